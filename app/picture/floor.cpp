#include "app/picture/floor.h"

#include <algorithm>
#include <limits>

#include "sim/study/sag.h"

namespace app {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

bool is_floor(const sim::Plane& plane, const Vec3& up) {
  return plane.normal.normalized().dot(up) > 0.1;
}
bool is_floor(const sim::Sphere&, const Vec3&) {
  return false;
}
bool is_floor(const sim::RigidSurface&, const Vec3&) {
  return false;
}

double lowest_of(const sim::Plane&, const Vec3&) {
  return infinite;
}
double lowest_of(const sim::Sphere& sphere, const Vec3& up) {
  return up.dot(sphere.centre) - sphere.radius;
}

double lowest_of(const sim::RigidSurface& surface, const Vec3& up) {
  return (up.transpose() * surface.X).minCoeff();
}

bool is_held(const sim::Body& body, const sim::Scene& scene) {
  return std::ranges::any_of(body.pins, [](const sim::Pin& pin) { return !pin.release; }) ||
         std::ranges::any_of(scene.springs, [&](const sim::Spring& spring) { return spring.body == body.name; });
}

bool something_falls(const sim::Scene& scene) {
  return scene.world.gravity.norm() > 0 &&
         !std::ranges::all_of(scene.bodies, [&](const sim::Body& body) { return is_held(body, scene); });
}

double lowest_of(const Eigen::Ref<const Eigen::VectorXd>& x, const Vec3& up) {
  const Eigen::Map<const Eigen::Matrix3Xd> points(x.data(), 3, x.size() / 3);
  return points.cols() == 0 ? 0 : (up.transpose() * points).minCoeff();
}

double expected_lowest(const sim::System& system, const sim::Scene& scene, const Vec3& up) {
  const sim::State start = system.initial_state();
  double lowest = lowest_of(system.of_bodies(start.x), up);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const sim::BodyRange& body = system.bodies()[b];
    const double sag = sim::expected_sag(system, b, scene.world.gravity);
    lowest = std::min(lowest, lowest_of(body.mesh->X.reshaped(), up) - sag);
  }
  for (const sim::Obstacle& obstacle : scene.obstacles)
    lowest = std::min(lowest, std::visit([&](const auto& shape) { return lowest_of(shape, up); }, obstacle.shape));
  return lowest;
}

}  // namespace

Floor::Floor(const sim::System& system, const Document& document, const Stand& stand)
    : system_(system), stand_(stand), given_(document.look.ground_height.has_value()) {
  const sim::Scene& scene = document.scene;
  if (system.dimension() == 2 || !document.look.ground) return;
  const auto floors = [&](const sim::Obstacle& obstacle) {
    return std::visit([&](const auto& shape) { return is_floor(shape, stand.up); }, obstacle.shape);
  };
  drawn_ = given_ || (!std::ranges::any_of(scene.obstacles, floors) && !something_falls(scene));
  if (!drawn_) return;
  gap_ = 1e-3 * rest_box(system.bodies()).sizes().maxCoeff();
  height_ = given_ ? *document.look.ground_height : expected_lowest(system, scene, stand.up) - gap_;
}

std::optional<render::Ground> Floor::at(const sim::State& state) const {
  if (!drawn_) return std::nullopt;
  const double lowest = given_ ? infinite : lowest_of(system_.of_bodies(state.x), stand_.up) - gap_;
  const double height = std::min(height_, lowest) - stand_.up.dot(stand_.origin);
  return render::Ground{to_point(height * stand_.up), to_point(stand_.up)};
}

}  // namespace app
