// A scene whose bodies cross or touch at the start.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/scene/scene_error.h"
#include "sim/math/vec3.h"

namespace app {

struct CrossedStart : SceneError {
  std::vector<sim::Vec3> places;  // m: where they do
  CrossedStart(const std::string& what, std::vector<sim::Vec3> places_)
      : SceneError(what), places(std::move(places_)) {}
};

}  // namespace app
