#include "app/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {
namespace {

constexpr double kMargin = 1.25;  // seen over needed

std::array<Vec3, 8> corners(const Eigen::AlignedBox3d& box) {
  std::array<Vec3, 8> points;
  for (int i = 0; i < 8; ++i) {
    points[static_cast<std::size_t>(i)] = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
  }
  return points;
}

// Radius of the ball around `centre` that holds the box.
double radius_around(const Vec3& centre, const Eigen::AlignedBox3d& box) {
  double radius = 0;
  for (const Vec3& corner : corners(box)) radius = std::max(radius, (corner - centre).norm());
  return radius > 0 ? radius : 1.0;
}

// From the front, a little from the side and from above.
Vec3 usual_direction(const Vec3& up) {
  const Vec3 front = std::abs(up.z()) < 0.9 ? Vec3::UnitZ() : Vec3(-Vec3::UnitY());
  const Vec3 side = up.cross(front).normalized();
  return (side.cross(up) + 0.45 * side + 0.35 * up).normalized();
}

render::Camera plane_view(const Camera& camera, const Vec3& target, const Eigen::AlignedBox3d& box, double aspect) {
  render::Camera view;
  const Vec3 half = (box.max() - target).cwiseMax(target - box.min());
  const double needed = 2 * kMargin * std::max(half.y(), half.x() / aspect);
  const double height = camera.height.value_or(needed > 0 ? needed : 1.0);
  view.orthographic = true;
  view.height = static_cast<float>(height);
  view.target = to_point(target);
  view.eye = to_point(target + height * Vec3::UnitZ());
  return view;
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
  // A ball of radius r just fits an opening angle 2a at distance r / sin a; in an upright picture the width decides.
  const double half_height = camera.fov / 2 * std::numbers::pi / 180;
  const double half_angle = std::min(half_height, std::atan(aspect * std::tan(half_height)));
  const double distance = kMargin * radius_around(target, box) / std::sin(half_angle);
  render::Camera view;
  view.target = to_point(target);
  view.eye = to_point(camera.eye.value_or(target + distance * usual_direction(camera.up)));
  view.up = to_point(camera.up);
  view.field_of_view = static_cast<float>(camera.fov);
  return view;
}

std::optional<render::Ground> ground_of(const Look& look, const Vec3& up, const Eigen::AlignedBox3d& box) {
  if (!look.ground) return std::nullopt;
  double lowest = up.dot(box.min());
  for (const Vec3& corner : corners(box)) lowest = std::min(lowest, up.dot(corner));
  // A gap that cannot be seen, but keeps the floor from flickering through the faces that lie on it.
  const double height = look.ground_height.value_or(lowest - 1e-3 * box.sizes().maxCoeff());
  return render::Ground{to_point(height * up), to_point(up)};
}

void add_obstacles(std::span<const sim::Obstacle> obstacles, render::Frame& frame) {
  for (const sim::Obstacle& obstacle : obstacles) {
    if (const auto* plane = std::get_if<sim::Plane>(&obstacle.shape)) {
      frame.planes.push_back({to_point(plane->point), to_point(plane->normal)});
    } else {
      const auto& sphere = std::get<sim::Sphere>(obstacle.shape);
      frame.spheres.push_back({to_point(sphere.centre), static_cast<float>(sphere.radius)});
    }
  }
}

}  // namespace app
