// What is carried along while it spreads: the smallest problem that is not self-adjoint.
#pragma once

#include "sim/residual/problem.h"

namespace sim::residual {

// -eps u'' + u' = 1, with its exact solution.
Problem advection_diffusion(Real eps);

// Péclet's number of a cell of n hats, h/(2 eps): above 1 their coefficients, which are values at nodes, swing.
Real cell_peclet(Real eps, int n);

// How far values at the nodes i/(n + 1) lie above u = x at most, which the solution never does; 0 where none does.
Real overshoot(const Vector& nodes);

}  // namespace sim::residual
