#include "app/picture/camera_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/picture/stage.h"

namespace app {
namespace {

constexpr double swing = 1.1;  // how far a body may leave the first box, as a share of it, before the camera moves

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

// What of an obstacle the bodies may come to: of a plane, where they fall on it.
// Others have their nearest part beside the bodies, where it is as near as a body is large.
Eigen::AlignedBox3d reached(const sim::Plane& plane, const Eigen::AlignedBox3d& bodies, double near_by,
                            const Vec3& down) {
  Eigen::AlignedBox3d box;
  const double along = plane.normal.dot(down);
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner = bodies.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    const double height = plane.normal.dot(corner - plane.point);
    if (!(along < -0.1)) {
      if (std::abs(height) < bodies.sizes().norm()) box.extend(Vec3(corner - height * plane.normal));
      continue;
    }
    const double fall = plane.normal.dot(plane.point - corner) / along;
    if (fall > 0 && fall < near_by) box.extend(corner + fall * down);
  }
  return box;
}

// A sphere that is far larger than the bodies is seen where they are.
Eigen::AlignedBox3d reached(const sim::Sphere& ball, const Eigen::AlignedBox3d& bodies, double near_by, const Vec3&) {
  const Vec3 reach = Vec3::Constant(ball.radius);
  const Eigen::AlignedBox3d all(ball.centre - reach, ball.centre + reach);
  if (!(bodies.exteriorDistance(ball.centre) < near_by + ball.radius)) return {};
  const double size = bodies.sizes().norm();
  if (ball.radius < 5 * size) return all;
  const Vec3 foot = ball.centre + ball.radius * (bodies.center() - ball.centre).normalized();
  const Vec3 part = Vec3::Constant(size / 2);
  return all.intersection({foot - part, foot + part});
}

// A surface is seen whole, as far as bodies may come to it.
Eigen::AlignedBox3d reached(const sim::RigidSurface& surface, const Eigen::AlignedBox3d& bodies, double near_by,
                            const Vec3&) {
  Eigen::AlignedBox3d box;
  for (const auto& node : surface.X.colwise()) {
    Vec3 x = Vec3::Zero();
    x.head(node.size()) = node;
    if (bodies.exteriorDistance(x) < near_by) box.extend(x);
  }
  return box;
}

// The bodies at rest and where they will fall: the scene tells both before a step is taken.
Eigen::AlignedBox3d first_box(const sim::System& system, const sim::Scene& scene) {
  Eigen::AlignedBox3d box = rest_box(system.bodies());
  const Eigen::AlignedBox3d bodies = box;
  const double near_by = 20 * bodies.sizes().norm();
  const Vec3 down = scene.world.gravity.normalized();
  for (const sim::Obstacle& obstacle : scene.obstacles)
    box.extend(std::visit([&](const auto& shape) { return reached(shape, bodies, near_by, down); }, obstacle.shape));
  if (scene.dimension == 2) box.min().z() = box.max().z() = 0;
  return box;
}

Eigen::AlignedBox3d box_of(const Eigen::Ref<const Eigen::VectorXd>& x, int dimension) {
  const Eigen::Map<const Eigen::MatrixXd> points(x.data(), dimension, x.size() / dimension);
  Eigen::AlignedBox3d box{Vec3::Zero(), Vec3::Zero()};
  if (points.size() == 0) return box;
  box.min().head(dimension) = points.rowwise().minCoeff();
  box.max().head(dimension) = points.rowwise().maxCoeff();
  return box;
}

// Between two poses by s^2 (3 - 2 s): the camera speeds up and slows down.
CameraPose pose_at(const std::vector<CameraPose>& keyframes, double t) {
  if (keyframes.empty()) return {};
  const auto after = std::ranges::upper_bound(keyframes, t, {}, &CameraPose::t);
  if (after == keyframes.begin()) return keyframes.front();
  if (after == keyframes.end()) return keyframes.back();
  const CameraPose &a = *(after - 1), &b = *after;
  const double s = (t - a.t) / (b.t - a.t), share = s * s * (3 - 2 * s);
  return {t, std::lerp(a.turn, b.turn, share), std::lerp(a.tilt, b.tilt, share),
          a.zoom * std::pow(b.zoom / a.zoom, share)};
}

// From the target to the eye, turned about `up` and raised, but never as far as straight above or below.
Vec3 turned(const Vec3& arm, const Vec3& up, double turn, double tilt) {
  const Vec3 around = Eigen::AngleAxisd(radians(turn), up) * arm;
  if (tilt == 0) return around;
  const double height = std::asin(std::clamp(around.normalized().dot(up), -1.0, 1.0));
  const double wanted = std::clamp(height + radians(tilt), -radians(89), radians(89));
  const Vec3 level = (around - around.dot(up) * up).normalized();
  return around.norm() * (std::cos(wanted) * level + std::sin(wanted) * up);
}

}  // namespace

CameraPath::CameraPath(const sim::System& system, const Document& document, double aspect, double margin)
    : system_(system),
      camera_(document.camera),
      stand_(stand_of(document, system)),
      aspect_(aspect),
      margin_(margin),
      first_(first_box(system, document.scene)) {
  for (const sim::BodyRange& body : system.bodies()) {
    if (!camera_.follow.empty() && body.name == camera_.follow) followed_ = &body;
  }
  if (followed_ != nullptr) start_ = middle_of_followed(system.initial_state().x);
}

Vec3 CameraPath::middle_of_followed(const Eigen::VectorXd& x) const {
  const int D = system_.dimension();
  const Eigen::Map<const Eigen::MatrixXd> points(x.data() + std::ptrdiff_t{D} * followed_->first_node, D,
                                                 followed_->node_count);
  Vec3 middle = Vec3::Zero();
  middle.head(D) = points.rowwise().mean();
  return middle;
}

render::Camera CameraPath::at(const sim::State& state) const {
  Eigen::AlignedBox3d box = first_;
  if (followed_ == nullptr) {
    const Eigen::AlignedBox3d now = box_of(system_.of_bodies(state.x), system_.dimension());
    const Vec3 middle = first_.center();
    box.extend(Vec3(middle + (now.min() - middle) / swing));
    box.extend(Vec3(middle + (now.max() - middle) / swing));
  }
  render::Camera view = view_of(camera_, stand_, box, system_.dimension(), aspect_, margin_);
  const double t = system_.time(state.step);
  const CameraPose pose = pose_at(camera_.keyframes, t);
  const Vec3 shift = followed_ != nullptr ? Vec3(middle_of_followed(state.x) - start_) : Vec3(Vec3::Zero());
  const Vec3 target = to_vec3(view.target) + shift;
  Vec3 arm = to_vec3(view.eye) - to_vec3(view.target);
  if (!view.orthographic) arm = turned(arm, stand_.up, pose.turn + camera_.orbit * t, pose.tilt);
  view.target = to_point(target);
  view.eye = to_point(target + arm);
  view.height = static_cast<float>(view.height / pose.zoom);
  const double half = std::tan(radians(view.field_of_view) / 2) / pose.zoom;
  view.field_of_view = static_cast<float>(2 * std::atan(half) * 180 / std::numbers::pi);
  return view;
}

}  // namespace app
