// The second derivative of a function of the distance, as it stands or made positive semidefinite.
//   H = b'' g g^T + b' Hess d,  g = grad d, b' <= 0
// Its range is spanned by c (x) n, c_k (x) n and c (x) t for the tangents t: an eigenproblem of 5 numbers at most gives
// the clamp of the 12 x 12. Where d is far below the primitives' size, b'' g g^T alone is as good.
#pragma once

#include "sim/contact/distance.h"
#include "sim/material/tangent.h"

namespace sim {

// first, second: b' and b''
PairMatrix pair_tangent(const Distance& distance, double first, double second, Definiteness fix);

// A symmetric matrix without its negative part.
PairMatrix without_negative_part(const PairMatrix& A);

}  // namespace sim
