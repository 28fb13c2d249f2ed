// From where a scene is seen, and what stands around its bodies.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>

#include "app/scene/look.h"
#include "render/frame.h"
#include "sim/scene.h"
#include "sim/system.h"

namespace app {

// What holds all bodies at rest [m]; z = 0 in 2D. The origin when there is none.
Eigen::AlignedBox3d rest_box(std::span<const sim::BodyRange> bodies);

// The camera that the scene names, without its motion; what it leaves out is chosen so that the box is seen, with a
// margin for text and to move in. `aspect`: width / height of the picture.
render::Camera view_of(const Camera& camera, const Eigen::AlignedBox3d& box, int dimension, double aspect);

// The floor that the look asks for; where its height is left open, none over a plane obstacle that is one.
std::optional<render::Ground> ground_of(const Look& look, const Vec3& up, const Eigen::AlignedBox3d& box,
                                        std::span<const sim::Obstacle> obstacles);

void add_obstacles(std::span<const sim::Obstacle> obstacles, render::Frame& frame);

render::Point to_point(const Vec3& v);

}  // namespace app
