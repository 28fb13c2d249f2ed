// From where a scene is seen, and what stands around its bodies.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>

#include "app/scene/document.h"
#include "render/frame.h"
#include "sim/scene.h"
#include "sim/system.h"

namespace app {

// What holds all bodies at rest [m]; z = 0 in 2D. The origin when there is none.
Eigen::AlignedBox3d rest_box(std::span<const sim::BodyRange> bodies);

// Which way is up, and from where pictures count: single precision has no digits to spare far from the origin.
struct Stand {
  Vec3 up = {0, 1, 0};      // unit
  Vec3 origin = {0, 0, 0};  // m: positions in a picture are relative to it
};

// Up is against gravity where the camera does not say; the origin is the scene's own unless that lies more than a
// thousand times its size away.
Stand stand_of(const Document& document, const sim::System& system);

// How much more is seen than what is to be seen.
constexpr double margin_in_room = 1.15;     // beside what else stands in the picture: enough to swing in
constexpr double margin_in_picture = 1.25;  // of all of the picture

// The camera that the scene names, without its motion; what it leaves out is chosen so that the box is seen, with a
// margin to move in. `aspect`: width / height of the picture.
render::Camera view_of(const Camera& camera, const Stand& stand, const Eigen::AlignedBox3d& box, int dimension,
                       double aspect, double margin = margin_in_picture);

// What the whole picture would show is seen smaller, and its middle is the middle of this part of the picture.
void place_in(const render::Box& part, double aspect, render::Camera& camera);

// A plane or a sphere.
void add_obstacle(const sim::ObstacleShape& obstacle, const Vec3& origin, render::Frame& frame);

render::Point to_point(const Vec3& v);
Vec3 to_vec3(const render::Point& p);

// What the picture shows at the target, from below to above [m].
double visible_height(const render::Camera& camera);

}  // namespace app
