// Coulomb's law without its jump: f1 rises smoothly from 0 to 1 at the speed eps; f0' = f1. Twice continuously
// differentiable at eps. [Li et al. 2020]
#pragma once

#include "sim/math/vec3.h"

namespace sim {

struct SmoothFriction {
  double f0, f1, slope;  // m/s, -, s/m
  SmoothFriction(double speed, double eps) {
    const double y = speed / eps;
    f0 = y >= 1 ? speed : eps * (y * y - y * y * y / 3 + 1.0 / 3);
    f1 = y >= 1 ? 1 : y * (2 - y);
    slope = y >= 1 ? 0 : 2 * (1 - y) / eps;
  }
};

// The part of a velocity across a unit normal.
inline Vec3 slip_of(const Vec3& v, const Vec3& n) {
  return v - n.dot(v) * n;
}

// d f0/d slip, and d2 f0/d slip2 on the tangent plane: positive semidefinite as it stands.
inline Vec3 slip_gradient(const Vec3& slip, double eps) {
  const double speed = slip.norm();
  return speed > 0 ? Vec3(SmoothFriction(speed, eps).f1 / speed * slip) : Vec3(Vec3::Zero());
}
inline Eigen::Matrix3d slip_tangent(const Vec3& slip, const Vec3& n, double eps) {
  const double speed = slip.norm();
  const SmoothFriction f(speed, eps);
  const Vec3 along = speed > 0 ? Vec3(slip / speed) : Vec3(Vec3::Zero());
  const double across = speed > 0 ? f.f1 / speed : f.slope;
  const Eigen::Matrix3d plane = Eigen::Matrix3d::Identity() - n * n.transpose();
  return across * (plane - along * along.transpose()) + f.slope * along * along.transpose();
}

}  // namespace sim
