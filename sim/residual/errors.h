// How far a trial function is from the solution.
#pragma once

#include <optional>

#include "sim/residual/problem.h"

namespace sim::residual {

// Of e = u_n - u.
struct Errors {
  Real L2 = 0;                      // sqrt int e^2
  Real H1_seminorm = 0;             // sqrt int e'^2
  std::optional<Real> energy_norm;  // sqrt int k e'^2 + q e^2; none where L is not self-adjoint or that is negative
  std::optional<Real> residual_L2;  // sqrt int (L u_n - f)^2; none where the basis has no second derivative
  Real max_1001 = 0;                // largest |e| at x = k/1000
  std::optional<Real> F;            // int k u_n'^2/2 + q u_n^2/2 - f u_n; none where L is not self-adjoint
};

// The problem's exact function must be there.
Errors measure(const Problem& problem, const Trial& trial, bool self_adjoint);

// int u_i (L u_n - f) for every u_i of a smooth basis: what Galerkin's method makes zero.
Vector weighted_residuals(const Problem& problem, const Trial& trial);

// Observed order of an error that falls like h^order, from n to m terms: h is the cell 1/(n + 1) of hats, else 1/n.
Real order(const Basis& basis, int n, Real error_n, int m, Real error_m);

}  // namespace sim::residual
