// Where the integrals over [0,1] are taken: panels on which the functions of a problem are resolved, and points in
// them.
#pragma once

#include <vector>

#include "sim/residual/problem.h"

namespace sim::residual {

// Ends of the panels, from 0 to 1. The nodes i/(n + 1) of n hats are among them. A panel is halved until the Legendre
// coefficients of k, k', a, q, f, u and u' have fallen to round-off on it, or it is 2^-30 of the first ones wide, as
// at a kink. Throws ProblemError where a function is not integrable or swings too fast.
std::vector<Real> make_panels(const Problem& problem, int n);

// Quadrature points in (0,1): int g = sum weight_p g(x_p).
struct Grid {
  Vector x, weight;
};

// 20 Gauss points on each of these panels.
Grid gauss_grid(const Problem& problem, int n);

}  // namespace sim::residual
