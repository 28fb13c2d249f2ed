// How a scene is seen: plain data. Lengths in metres; in a 2D scene the third number of a vector is zero.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "sim/scene.h"

namespace app {

using sim::Vec3;

struct Camera {
  std::optional<Vec3> eye;       // m, 3D only; none: far enough from the target to see every body
  std::optional<Vec3> target;    // m, the point in the middle of the picture; none: the middle of the bodies at rest
  Vec3 up = {0, 1, 0};           // 3D only: the direction that is up in the picture
  double fov = 30;               // degrees, 3D only: vertical opening angle
  std::optional<double> height;  // m, 2D only: height of what is seen; none: every body is seen
};

struct Look {
  std::string colour = "plain";                // "plain" | "stress" (von Mises) | "stretch" | "energy" | "J"
  std::optional<std::array<double, 2>> range;  // values at the ends of the colour map; none: from the values themselves
  std::string caption = "t = {t} s";           // {t} [s], {frame}, {step} = h [s], {energy} [J], {iterations}
  bool wireframe = false;                      // edges of the elements over the faces
  bool ground = true;                          // 3D: a floor below the bodies, which shows where they are
  std::optional<double> ground_height;         // m along `up`; none: just below the lowest body at rest
};

}  // namespace app
