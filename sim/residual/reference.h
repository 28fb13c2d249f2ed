// The solution of a problem whose exact one is not known.
#pragma once

#include "sim/residual/problem.h"

namespace sim::residual {

struct Reference {
  Function u;
  int panels = 0, points = 0;  // of the collocation: points on each panel
  Real change = 0;             // at x = k/1000 by halving all panels, of the largest |u|
};

// Collocation of the first-order system at Gauss points, panel by panel, on panels halved until u and k u' are
// resolved on each. Throws ProblemError where the problem has no solution or many.
Reference compute_reference(const Problem& problem);

}  // namespace sim::residual
