// Vibration modes of a body at rest: K psi = omega^2 M psi with the body's own stiffness, mass and pins.
#pragma once

#include <Eigen/Core>

#include "sim/scene.h"

namespace sim {

// The slowest ones first; rigid motions of a body that is free have omega = 0.
struct Modes {
  Eigen::VectorXd omega;  // rad/s
  Eigen::MatrixXd shape;  // D numbers per node x modes; psi^T M psi = 1, the largest component is positive
};

// At most `count` modes of the body with this number, as if it were alone in the scene; fewer where it has fewer free
// components. Loads, obstacles and damping do not tell. Throws InputError where the body cannot be built.
Modes vibration_modes(const Scene& scene, std::size_t body, int count);

// The fastest of all [rad/s], 0 where all nodes are pinned: explicit schemes are stable for h < 2/omega.
double fastest_frequency(const Scene& scene, std::size_t body);

// The same scene, where every body with start.shape = "mode" has the positions of that start in start.nodes.
Scene with_modes_started(Scene scene);
bool starts_in_a_mode(const Scene& scene);

}  // namespace sim
