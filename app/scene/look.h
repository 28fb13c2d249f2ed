// How a scene is seen: plain data. Lengths in metres; in a 2D scene the third number of a vector is zero.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/scene.h"

namespace app {

using sim::Vec3;

// A camera at a moment of its script, compared with where it stands without one.
struct CameraPose {
  double t = 0;     // s
  double turn = 0;  // degrees about `up` through the target, right-handed; 3D only
  double tilt = 0;  // degrees upwards; 3D only
  double zoom = 1;  // > 0; 2: everything is seen twice as large
};

struct Camera {
  std::optional<Vec3> eye;            // m, 3D only; none: far enough from the target to see every body
  std::optional<Vec3> target;         // m, the point in the middle of the picture; none: the middle of what is seen
  std::optional<Vec3> up;             // 3D only: the direction that is up in the picture; none: against gravity
  double fov = 30;                    // degrees, 3D only: vertical opening angle
  std::optional<double> height;       // m, 2D only: height of what is seen; none: every body is seen
  double orbit = 0;                   // degrees/s, 3D only: an even turn about `up`, added to the script
  std::vector<CameraPose> keyframes;  // the script: times increase, eased from pose to pose
  std::string follow;                 // name of the body that eye and target move with; empty: none
};

// The direction that is up: against gravity where the camera leaves it open.
inline Vec3 up_of(const Camera& camera, const Vec3& gravity) {
  if (camera.up) return *camera.up;
  return gravity.norm() > 0 ? Vec3(-gravity.normalized()) : Vec3(Vec3::UnitY());
}

struct Look {
  std::string style = "usual";   // "usual" | "lecture": to be read from the last row of a hall
  std::string colour = "plain";  // "plain" | "stress" (von Mises) | "stretch" | "energy" | "J" | "pressure"
  std::optional<std::array<double, 2>> range;  // values at the ends of the colour map; none: from the values themselves
  std::optional<std::string> colour_map;       // one of render/colour_map.h; none: what suits the values
  std::optional<std::string> background;       // "studio" | "paper"; none: paper in 2D
  std::string finish = "rubber";               // "rubber" | "jelly"
  std::string caption = "t = {t} s";           // {names} stand for live values, see app/scene/caption_names.h
  bool wireframe = false;                      // edges of the elements over the faces
  bool smooth = true;                          // 3D: faces between smooth neighbours are drawn round
  bool shadows = true;                         // 3D: soft shadows and darkened creases
  bool ground = true;                          // 3D: a floor below what stays there, which shows where it is
  std::optional<double> ground_height;         // m along `up`; none: below the lowest body and obstacle
  bool ghost = false;                          // the rest shape, translucent
  bool pins = false;                           // a dot at each pinned node of the surface
  bool obstacles = true;                       // obstacles are drawn
  bool forces = false;                         // arrows: loads, contact and what holds the pinned nodes
  bool contact_forces = false;                 // arrows: contact alone
  std::optional<double> force_scale;           // m/N, length of an arrow; none: from the weight and the loads
  bool velocities = false;                     // arrows
  std::optional<double> velocity_scale;        // s, the way that an arrow covers; none: from the size of the scene
  std::optional<bool> labels;                  // names of the bodies; none: when there are several
  bool energies = false;                       // kinetic, elastic, potential and total energy over time
  bool axes = false;                           // 2D: ticks along the left and the lower edge
  bool scale_bar = false;                      // 2D: a bar of round length
};

}  // namespace app
