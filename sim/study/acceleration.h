// What the forces of a state make of it: M a = -dU/dx on the free components.
#pragma once

#include <Eigen/Core>

#include "sim/system.h"

namespace sim {

// m/s^2, of every term of the system, damping too; zero where a node is pinned.
Eigen::VectorXd accelerations(const System& system, const State& state);

}  // namespace sim
