#include "app/picture/stage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {
namespace {

constexpr double margin = 1.25;  // seen over needed

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
                        double tan_width, double tan_height) {
  const Vec3 right = up.cross(direction).normalized(), upright = direction.cross(right);
  double distance = 0;
  for (const Vec3& corner : corners(box)) {
    const Vec3 p = corner - target;
    const double needed = std::max(std::abs(p.dot(right)) / tan_width, std::abs(p.dot(upright)) / tan_height);
    distance = std::max(distance, p.dot(direction) + margin * needed);
  }
  return distance > 0 ? distance : 1.0;
}

render::Camera plane_view(const Camera& camera, const Vec3& target, const Eigen::AlignedBox3d& box, double aspect) {
  render::Camera view;
  const Vec3 half = (box.max() - target).cwiseMax(target - box.min());
  const double needed = 2 * margin * std::max(half.y(), half.x() / aspect);
  const double height = camera.height.value_or(needed > 0 ? needed : 1.0);
  view.orthographic = true;
  view.height = static_cast<float>(height);
  view.target = to_point(target);
  view.eye = to_point(target + height * Vec3::UnitZ());
  return view;
}

bool is_floor(const sim::Plane& plane, const Vec3& up) {
  return plane.normal.dot(up) > 0.7;
}
bool is_floor(const sim::Sphere&, const Vec3&) {
  return false;
}

void draw(const sim::Plane& plane, render::Frame& frame) {
  frame.planes.push_back({to_point(plane.point), to_point(plane.normal)});
}
void draw(const sim::Sphere& sphere, render::Frame& frame) {
  frame.spheres.push_back({to_point(sphere.centre), static_cast<float>(sphere.radius)});
}

}  // namespace

render::Point to_point(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
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

render::Camera view_of(const Camera& camera, const Eigen::AlignedBox3d& box, int dimension, double aspect) {
  const Vec3 target = camera.target.value_or(box.center());
  if (dimension == 2) return plane_view(camera, target, box, aspect);
  const double tan_height = std::tan(camera.fov / 2 * std::numbers::pi / 180);
  const Vec3 direction = usual_direction(camera.up);
  const double distance = fitting_distance(box, target, direction, camera.up, aspect * tan_height, tan_height);
  render::Camera view;
  view.target = to_point(target);
  view.eye = to_point(camera.eye.value_or(target + distance * direction));
  view.up = to_point(camera.up);
  view.field_of_view = static_cast<float>(camera.fov);
  return view;
}

std::optional<render::Ground> ground_of(const Look& look, const Vec3& up, const Eigen::AlignedBox3d& box,
                                        std::span<const sim::Obstacle> obstacles) {
  if (!look.ground) return std::nullopt;
  const auto floors = [&](const sim::Obstacle& obstacle) {
    return std::visit([&](const auto& shape) { return is_floor(shape, up); }, obstacle.shape);
  };
  if (look.obstacles && !look.ground_height && std::ranges::any_of(obstacles, floors)) return std::nullopt;
  double lowest = up.dot(box.min());
  for (const Vec3& corner : corners(box)) lowest = std::min(lowest, up.dot(corner));
  // A gap that cannot be seen, but keeps the floor from flickering through the faces that lie on it.
  const double height = look.ground_height.value_or(lowest - 1e-3 * box.sizes().maxCoeff());
  return render::Ground{to_point(height * up), to_point(up)};
}

void add_obstacles(std::span<const sim::Obstacle> obstacles, render::Frame& frame) {
  for (const sim::Obstacle& obstacle : obstacles)
    std::visit([&](const auto& shape) { draw(shape, frame); }, obstacle.shape);
}

}  // namespace app
