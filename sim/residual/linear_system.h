// The small dense systems that the methods end in.
#pragma once

#include "sim/residual/method.h"

namespace sim::residual {

// c of A c = b, or the word that A is singular.
Answer solve_system(const Matrix& A, const Vector& b);

// Every row of `rows` = (L u_1, ..., L u_n) at one of the points.
Matrix apply_to_basis(const Problem& problem, const Basis& basis, int n, const Vector& points);

// g at every point
Vector values(const Function& g, const Vector& points);

}  // namespace sim::residual
