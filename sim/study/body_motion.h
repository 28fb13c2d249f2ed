// Motion of one body of a system in a few numbers.
#pragma once

#include "sim/system.h"

namespace sim {

// kg m/s, and kg m^2/s about the body's centre of mass.
struct Momentum {
  Vec3 linear = {0, 0, 0}, angular = {0, 0, 0};
};
Momentum momentum(const System& system, const State& state, std::size_t body);

// How far the body is displaced along a mode, q = psi^T M (x - X) with psi^T M psi = 1, and dq/dt.
struct ModalMotion {
  double q = 0, rate = 0;
};
ModalMotion modal_motion(const System& system, const State& state, std::size_t body, const Eigen::VectorXd& psi);

}  // namespace sim
