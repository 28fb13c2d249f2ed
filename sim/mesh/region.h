// Where: nodes inside a box or a sphere at rest, or a group of the mesh.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "sim/math/vec3.h"

namespace sim {

struct Box {
  Vec3 low, high;
};
struct Sphere {
  Vec3 centre;
  double radius = 0;
};
struct InGroup {
  std::string name;
  std::optional<int> dimension = {};  // needed where groups of several dimensions have the name
};
using Region = std::variant<Box, Sphere, InGroup>;

}  // namespace sim
