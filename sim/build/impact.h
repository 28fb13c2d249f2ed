// How hard bodies may hit each other, as far as the scene tells, and how stiff barriers between them are to be.
#pragma once

#include "sim/build/parts.h"

namespace sim {

// m/s, of body b or obstacle k: the largest speed of any place of it by its velocity and spin at the start or by
// keyframes, as if all of it moved as they move what is pinned. 0 in statics. What gravity makes of a long fall is not
// known.
double speed_of_body(const Parts& parts, std::size_t b);
double speed_of_obstacle(const Parts& parts, std::size_t k);

// kappa [Pa] of a barrier that keeps a body from what it meets at this speed: of 0.1 E and 0.1 rho v^2 the larger,
// with the smallest Young's modulus and the largest density of the body. At the pressure of the impact, about rho v^2,
// the gap is an eighth of the width of the barrier then: with 0.1 E alone a jelly that is hit at ten times the speed of
// its waves has gaps near round-off.
double barrier_stiffness(const Body& body, double speed);

}  // namespace sim
