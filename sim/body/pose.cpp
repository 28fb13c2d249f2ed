#include "sim/body/pose.h"

#include <Eigen/Geometry>

namespace sim {

namespace {

constexpr double radians = 3.14159265358979323846 / 180;

}  // namespace

Pose::Pose(const std::vector<Keyframe>& motion, double t) {
  if (motion.empty()) return;
  std::size_t k = 0;
  while (k < motion.size() && motion[k].t < t) ++k;
  at_ = motion[k == motion.size() ? k - 1 : k];
  if (k == 0 || k == motion.size()) return;
  const Keyframe &from = motion[k - 1], &to = motion[k];
  const double span = to.t - from.t, s = (t - from.t) / span;
  at_.translate = (1 - s) * from.translate + s * to.translate;
  at_.degrees = (1 - s) * from.degrees + s * to.degrees;
  translate_rate_ = (to.translate - from.translate) / span;
  turn_rate_ = radians * (to.degrees - from.degrees) / span;
}

Vec3 Pose::turned(const Vec3& direction) const {
  return Eigen::AngleAxisd(at_.degrees * radians, at_.axis.normalized()) * direction;
}

Vec3 Pose::place(const Vec3& X) const {
  return at_.centre + turned(X - at_.centre) + at_.translate;
}

Vec3 Pose::velocity(const Vec3& x) const {
  return turn_rate_ * at_.axis.normalized().cross(x - at_.centre - at_.translate) + translate_rate_;
}

}  // namespace sim
