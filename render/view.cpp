#include "render/view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace render {

void Bounds::add(const Eigen::Vector3f& point) {
  low = low.cwiseMin(point);
  high = high.cwiseMax(point);
}

Eigen::Vector3f Bounds::corner(int k) const {
  return {(k & 1) != 0 ? high.x() : low.x(), (k & 2) != 0 ? high.y() : low.y(), (k & 4) != 0 ? high.z() : low.z()};
}

namespace {

void add_positions(Bounds& bounds, const std::vector<float>& positions) {
  if (positions.empty()) return;
  const Eigen::Map<const Eigen::Matrix3Xf> points(positions.data(), 3, static_cast<Eigen::Index>(positions.size() / 3));
  bounds.add(points.rowwise().minCoeff());
  bounds.add(points.rowwise().maxCoeff());
}

void check_camera(const Camera& camera, const Eigen::Vector3f& ahead) {
  if (!to_vector(camera.eye).allFinite() || !to_vector(camera.target).allFinite()) {
    throw std::invalid_argument("camera: eye and target must be finite");
  }
  if (!(ahead.norm() > 0)) throw std::invalid_argument("camera: eye and target are the same point");
  if (!(ahead.cross(to_vector(camera.up)).norm() > 1e-6F * ahead.norm())) {
    throw std::invalid_argument("camera: up is parallel to the direction of view");
  }
  if (!camera.orthographic && !(camera.field_of_view > 0 && camera.field_of_view < 180)) {
    throw std::invalid_argument("camera: field of view is " + std::to_string(camera.field_of_view) +
                                ", must lie between 0 and 180 degrees");
  }
  if (camera.orthographic && !(camera.height > 0 && std::isfinite(camera.height))) {
    throw std::invalid_argument("camera: height is " + std::to_string(camera.height) + ", must be above 0");
  }
}

// Clip planes that hold everything: the solids of the frame, and the ground up to where it has faded.
void set_clip_planes(View& view, float distance, const Bounds& bounds) {
  float nearest = distance, farthest = distance + 10 * view.extent;
  for (int k = 0; k < 8 && !bounds.empty(); ++k) {
    const float depth = (bounds.corner(k) - view.eye).dot(view.forward);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  const float margin = 0.05F * view.extent;
  view.far_distance = farthest + margin;
  // A parallel camera sees what is behind its eye as well. The ground comes nearer than the solids.
  view.near_distance = view.orthographic ? std::min(nearest - margin, 0.0F)
                                         : std::clamp(nearest - margin, 0.01F * distance, 0.08F * distance);
}

}  // namespace

Bounds bounds_of(const Frame& frame) {
  Bounds bounds;
  for (const Surface& surface : frame.surfaces) add_positions(bounds, surface.positions);
  for (const Surface& ghost : frame.ghosts) add_positions(bounds, ghost.positions);
  for (const SphereObstacle& sphere : frame.spheres) {
    bounds.add(to_vector(sphere.centre).array() - sphere.radius);
    bounds.add(to_vector(sphere.centre).array() + sphere.radius);
  }
  for (const Arrow& arrow : frame.arrows) {
    bounds.add(to_vector(arrow.from));
    bounds.add(to_vector(arrow.to));
  }
  for (const Marker& marker : frame.markers) bounds.add(to_vector(marker.at));
  return bounds;
}

// Row by row: x_clip = A x_eye, with w = -z_eye for perspective (A = cot(angle/2)) and w = 1 for parallel projection.
View make_view(const Camera& camera, float aspect, const Bounds& bounds) {
  View view;
  view.eye = to_vector(camera.eye);
  view.target = to_vector(camera.target);
  const Eigen::Vector3f ahead = view.target - view.eye;
  check_camera(camera, ahead);
  const float distance = ahead.norm();
  view.forward = ahead / distance;
  view.right = view.forward.cross(to_vector(camera.up)).normalized();
  view.up = view.right.cross(view.forward);
  view.orthographic = camera.orthographic;
  const float tangent = std::tan(camera.field_of_view * std::numbers::pi_v<float> / 360);
  view.extent = camera.orthographic ? camera.height : 2 * distance * tangent;
  set_clip_planes(view, distance, bounds);

  Eigen::Matrix4f to_eye = Eigen::Matrix4f::Identity();
  to_eye.block<1, 3>(0, 0) = view.right.transpose();
  to_eye.block<1, 3>(1, 0) = view.up.transpose();
  to_eye.block<1, 3>(2, 0) = -view.forward.transpose();
  to_eye.block<3, 1>(0, 3) = -(to_eye.block<3, 3>(0, 0) * view.eye);

  const float n = view.near_distance, f = view.far_distance;
  Eigen::Matrix4f to_clip = Eigen::Matrix4f::Zero();
  if (camera.orthographic) {
    to_clip(0, 0) = 2 / (camera.height * aspect);
    to_clip(1, 1) = 2 / camera.height;
    to_clip(2, 2) = -2 / (f - n);
    to_clip(2, 3) = -(f + n) / (f - n);
    to_clip(3, 3) = 1;
  } else {
    to_clip(0, 0) = 1 / (tangent * aspect);
    to_clip(1, 1) = 1 / tangent;
    to_clip(2, 2) = -(f + n) / (f - n);
    to_clip(2, 3) = -2 * f * n / (f - n);
    to_clip(3, 2) = -1;
  }
  view.world_to_clip = to_clip * to_eye;
  return view;
}

Eigen::Vector3f View::to_window(const Eigen::Vector3f& point, int width, int height) const {
  const Eigen::Vector4f clip = world_to_clip * point.homogeneous();
  const float w = clip.w() == 0 ? 1e-20F : clip.w();
  return {(clip.x() / w * 0.5F + 0.5F) * static_cast<float>(width),
          (0.5F - clip.y() / w * 0.5F) * static_cast<float>(height), (point - eye).dot(forward)};
}

}  // namespace render
