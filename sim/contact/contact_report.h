// What a contact has to say at a moment, for each pair of bodies.
#pragma once

#include <limits>
#include <string>

#include "sim/math/vec3.h"

namespace sim {

struct ContactReport {
  std::string first, second;                             // names of bodies; the same twice: with itself
  int pairs = 0;                                         // that push
  double gap = std::numeric_limits<double>::infinity();  // m, the least; infinity: none near enough to be looked at
  double area = 0;                                       // m^2, over which they push
  Vec3 force = {0, 0, 0};                                // N, normal force on the first; 0 with itself
  Vec3 friction = {0, 0, 0};                             // N, on the first; 0 with itself
};

}  // namespace sim
