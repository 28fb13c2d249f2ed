// Bodies that may touch do not start apart.
#pragma once

#include <string>
#include <vector>

#include "sim/math/vec3.h"
#include "sim/mesh/input_error.h"

namespace sim {

struct StartError : InputError {
  std::vector<Vec3> places;  // m: where they cross or touch
  StartError(std::string key_, const std::string& what_, std::vector<Vec3> places_)
      : InputError(std::move(key_), what_), places(std::move(places_)) {}
};

}  // namespace sim
