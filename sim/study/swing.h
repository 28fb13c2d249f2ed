// The first swing of a body that is let go, in the time of its slowest motion.
#pragma once

#include "sim/scene.h"

namespace sim {

constexpr int steps_a_swing = 40;  // there and back

// The body with this number alone in its basis, of all of its elements, under its own loads as they are when they have
// risen, whatever the scheme of the scene.
Scene alone_in_basis(const Scene& scene, std::size_t number);

// How a body alone in its basis answers at rest.
struct Response {
  double omega = 0;          // rad/s, of the slowest motion
  Eigen::VectorXd per_axis;  // m: the largest displacement under a unit of acceleration along each axis
  double size = 0;           // m, of the body
};
Response response_in_basis(const Scene& alone);

// The same scene stepped by `trapezoidal`, with so many steps a period of this frequency.
Scene swinging(Scene scene, double omega);

// A scene of one body under nothing but a weight along an axis.
Scene under_weight(Scene alone, int axis, double acceleration);

}  // namespace sim
