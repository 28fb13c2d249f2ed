// A differential equation of second order on [0,1]:
//   L u = -(k u')' + a u' + q u = f,  u(0) = u(1) = 0.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "sim/residual/basis.h"
#include "sim/residual/real.h"

namespace sim::residual {

struct Problem {
  Function k, a, q, f;
  Function exact;  // u, given or computed; empty: unknown
};

// A problem that cannot be solved; `key` names the function at fault.
struct ProblemError : std::runtime_error {
  std::string key;
  ProblemError(std::string key_, const std::string& what_) : std::runtime_error(what_), key(std::move(key_)) {}
};

// (L u)(x) = -k u'' - k' u' + a u' + q u
Real apply(const Problem& problem, Real x, const Sample& u);

// Values are finite, k > 0, and u is 0 at both ends where it is known, at the 1001 points i/1000 (those inside, but for
// k and u). Throws ProblemError.
void check(const Problem& problem);

// int v L u - int u L v, which is 0 for all u and v where L is self-adjoint, for u = x (1 - x) and v = x^power u. The
// least power that shows the difference is taken; 0 stands for none: L is self-adjoint.
struct Asymmetry {
  int power = 0;
  Real difference = 0;
};
Asymmetry asymmetry(const Problem& problem);

}  // namespace sim::residual
