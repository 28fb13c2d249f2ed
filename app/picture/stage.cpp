#include "app/picture/stage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {
namespace {

std::array<Vec3, 8> corners(const Eigen::AlignedBox3d& box) {
  std::array<Vec3, 8> points;
  for (int i = 0; i < 8; ++i) {
    points[static_cast<std::size_t>(i)] = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
  }
  return points;
}

// From the front, a little from the side and from above.
Vec3 usual_direction(const Vec3& up) {
  const Vec3 front = std::abs(up.z()) < 0.9 ? Vec3::UnitZ() : Vec3(-Vec3::UnitY());
  const Vec3 side = up.cross(front).normalized();
  return (side.cross(up) + 0.45 * side + 0.35 * up).normalized();
}

// How far from the target an eye in this direction sees the whole box: a point p (from the target) is seen where
// |p.side| <= (distance - p.direction) tan(half angle), for both sides of the picture.
double fitting_distance(const Eigen::AlignedBox3d& box, const Vec3& target, const Vec3& direction, const Vec3& up,
                        double tan_width, double tan_height, double margin) {
  const Vec3 right = up.cross(direction).normalized(), upright = direction.cross(right);
  double distance = 0;
  for (const Vec3& corner : corners(box)) {
    const Vec3 p = corner - target;
    const double needed = std::max(std::abs(p.dot(right)) / tan_width, std::abs(p.dot(upright)) / tan_height);
    distance = std::max(distance, p.dot(direction) + margin * needed);
  }
  return distance > 0 ? distance : 1.0;
}

render::Camera plane_view(const Camera& camera, const Vec3& target, const Vec3& origin, const Eigen::AlignedBox3d& box,
                          double aspect, double margin) {
  render::Camera view;
  const Vec3 half = (box.max() - target).cwiseMax(target - box.min());
  const double needed = 2 * margin * std::max(half.y(), half.x() / aspect);
  const double height = camera.height.value_or(needed > 0 ? needed : 1.0);
  view.orthographic = true;
  view.height = static_cast<float>(height);
  view.target = to_point(target - origin);
  view.eye = to_point(target - origin + height * Vec3::UnitZ());
  return view;
}

void draw(const sim::Plane& plane, const Vec3& origin, render::Frame& frame) {
  frame.planes.push_back({to_point(plane.point - origin), to_point(plane.normal)});
}
void draw(const sim::Sphere& sphere, const Vec3& origin, render::Frame& frame) {
  frame.spheres.push_back({to_point(sphere.centre - origin), static_cast<float>(sphere.radius)});
}
// A surface of its own: app/picture/rigid_surface.h.
void draw(const sim::RigidSurface&, const Vec3&, render::Frame&) {}

}  // namespace

render::Point to_point(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

Vec3 to_vec3(const render::Point& p) {
  return {p[0], p[1], p[2]};
}

double visible_height(const render::Camera& camera) {
  if (camera.orthographic) return camera.height;
  const double distance = (to_vec3(camera.target) - to_vec3(camera.eye)).norm();
  return 2 * distance * std::tan(camera.field_of_view * std::numbers::pi / 360);
}

Eigen::AlignedBox3d rest_box(std::span<const sim::BodyRange> bodies) {
  Eigen::AlignedBox3d box;
  for (const sim::BodyRange& body : bodies) {
    for (const auto& X : body.mesh->X.colwise()) {
      Vec3 point = Vec3::Zero();
      point.head(X.size()) = X;
      box.extend(point);
    }
  }
  if (box.isEmpty()) box.extend(Vec3::Zero());
  return box;
}

Stand stand_of(const Document& document, const sim::System& system) {
  constexpr double far = 1e3;
  const Eigen::AlignedBox3d box = rest_box(system.bodies());
  const Vec3 middle = box.center();
  Stand stand;
  if (system.dimension() == 3) stand.up = up_of(document.camera, document.scene.world.gravity);
  if (middle.norm() > far * box.sizes().norm()) stand.origin = middle;
  return stand;
}

render::Camera view_of(const Camera& camera, const Stand& stand, const Eigen::AlignedBox3d& box, int dimension,
                       double aspect, double margin) {
  const Vec3 target = camera.target.value_or(box.center());
  if (dimension == 2) return plane_view(camera, target, stand.origin, box, aspect, margin);
  const double tan_height = std::tan(camera.fov / 2 * std::numbers::pi / 180);
  const Vec3 direction = usual_direction(stand.up);
  const double distance = fitting_distance(box, target, direction, stand.up, aspect * tan_height, tan_height, margin);
  render::Camera view;
  view.target = to_point(target - stand.origin);
  view.eye = to_point(camera.eye.value_or(target + distance * direction) - stand.origin);
  view.up = to_point(stand.up);
  view.field_of_view = static_cast<float>(camera.fov);
  return view;
}

void place_in(const render::Box& part, double aspect, render::Camera& camera) {
  const double share = std::min(part.right - part.left, part.bottom - part.top);
  const double extent = visible_height(camera) / share;
  Vec3 arm = to_vec3(camera.eye) - to_vec3(camera.target);
  if (!camera.orthographic) arm /= share;
  const Vec3 right = to_vec3(camera.up).cross(arm).normalized(), up = arm.cross(right).normalized();
  const Vec3 shift = (0.5 - (part.left + part.right) / 2) * aspect * extent * right -
                     (0.5 - (part.top + part.bottom) / 2) * extent * up;
  const Vec3 target = to_vec3(camera.target) + shift;
  camera.height = static_cast<float>(extent);
  camera.target = to_point(target);
  camera.eye = to_point(target + arm);
}

void add_obstacle(const sim::ObstacleShape& obstacle, const Vec3& origin, render::Frame& frame) {
  std::visit([&](const auto& shape) { draw(shape, origin, frame); }, obstacle);
}

}  // namespace app
