// The forces that act on the nodes from outside.
#pragma once

#include <Eigen/Core>

#include "sim/system.h"

namespace sim {

// N, D numbers per node.
struct Loads {
  Eigen::VectorXd applied;  // by tractions, pressures, point forces and springs
  Eigen::VectorXd contact;  // by what touches: other bodies, obstacles, a body itself; friction as well
  Eigen::VectorXd held;  // what keeps prescribed components where they are: minus the sum of all terms' forces there,
                         // without the inertia of nodes that are moved
};
Loads loads(const System& system, const State& state);

}  // namespace sim
