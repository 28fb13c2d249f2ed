#include "app/view/pick.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "app/picture/stage.h"
#include "render/view.h"

namespace app {
namespace {

using sim::Vec3;

// Distance along the ray to a triangle; infinity where it passes by. [Moeller and Trumbore 1997]
double distance_to(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const Vec3 e1 = b - a, e2 = c - a, p = ray.direction.cross(e2);
  const double det = e1.dot(p);
  if (det == 0) return never;
  const Vec3 s = ray.origin - a, q = s.cross(e1);
  const double u = s.dot(p) / det, v = ray.direction.dot(q) / det;
  const double t = e2.dot(q) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : never;
}

double distance_to(const Ray& ray, const render::Surface& surface) {
  const auto vertex = [&](std::uint32_t v) {
    const float* p = surface.positions.data() + 3 * static_cast<std::size_t>(v);
    return Vec3(p[0], p[1], p[2]);
  };
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 2 < surface.triangles.size(); k += 3) {
    nearest = std::min(nearest, distance_to(ray, vertex(surface.triangles[k]), vertex(surface.triangles[k + 1]),
                                            vertex(surface.triangles[k + 2])));
  }
  return nearest;
}

int nearest_node(const sim::System& system, const sim::State& state, int body, const Vec3& point) {
  int nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int node = 0; node < system.bodies()[static_cast<std::size_t>(body)].node_count; ++node) {
    const double distance = (place_of(system, state, body, node) - point).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    nearest = node;
  }
  return nearest;
}

}  // namespace

Ray ray_through(const render::Camera& camera, double aspect, double x, double y) {
  const render::View view = render::make_view(camera, static_cast<float>(aspect), {});
  const Vec3 across = (2 * x - 1) * aspect * view.right.cast<double>() + (1 - 2 * y) * view.up.cast<double>();
  const Vec3 seen = view.target.cast<double>() + 0.5 * view.extent * across;
  const Vec3 forward = view.forward.cast<double>(), eye = view.eye.cast<double>();
  if (view.orthographic) return {seen - (view.target - view.eye).cast<double>().norm() * forward, forward};
  return {eye, (seen - eye).normalized()};
}

sim::Vec3 on_plane(const Ray& ray, const render::Camera& camera, const sim::Vec3& point) {
  const Vec3 normal = (to_vec3(camera.target) - to_vec3(camera.eye)).normalized();
  return ray.origin + (point - ray.origin).dot(normal) / ray.direction.dot(normal) * ray.direction;
}

sim::Vec3 origin_of(const render::Frame& frame) {
  return Vec3(frame.origin[0], frame.origin[1], frame.origin[2]);
}

std::optional<Picked> pick(const Ray& ray, const render::Frame& frame, const sim::System& system,
                           const sim::State& state) {
  Picked picked;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t body = 0; body < system.bodies().size() && body < frame.surfaces.size(); ++body) {
    const double distance = distance_to(ray, frame.surfaces[body]);
    if (distance >= nearest) continue;
    nearest = distance;
    picked.body = static_cast<int>(body);
  }
  if (!std::isfinite(nearest)) return std::nullopt;
  const Vec3 hit = ray.origin + nearest * ray.direction;
  picked.node = nearest_node(system, state, picked.body, hit + origin_of(frame));
  const sim::Mesh& mesh = *system.bodies()[static_cast<std::size_t>(picked.body)].mesh;
  picked.rest.setZero();
  picked.rest.head(mesh.dimension()) = mesh.X.col(picked.node);
  picked.now = place_of(system, state, picked.body, picked.node);
  return picked;
}

sim::Vec3 place_of(const sim::System& system, const sim::State& state, int body, int node) {
  const int D = system.dimension();
  const int first = system.bodies()[static_cast<std::size_t>(body)].first_node;
  Vec3 place = Vec3::Zero();
  place.head(D) = state.x.segment(static_cast<Eigen::Index>(first + node) * D, D);
  return place;
}

}  // namespace app
