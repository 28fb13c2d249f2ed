#include "sim/contact/mollifier.h"

#include <Eigen/Geometry>

namespace sim {

double mollifier(const Vec3* x, double e) {
  const double z = (x[1] - x[0]).cross(x[3] - x[2]).squaredNorm() / e;
  return z < 1 ? z * (2 - z) : 1;
}

MollifierTangent::MollifierTangent(const Vec3* x, double e) {
  const Vec3 u = x[1] - x[0], v = x[3] - x[2];
  const double z = u.cross(v).squaredNorm() / e, uv = u.dot(v);
  M = z < 1 ? z * (2 - z) : 1;
  gradient.setZero();
  hessian.setZero();
  if (z >= 1) return;
  using Six = Eigen::Matrix<double, 6, 1>;
  const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
  Six dy;
  dy << 2 * (v.squaredNorm() * u - uv * v), 2 * (u.squaredNorm() * v - uv * u);
  Eigen::Matrix<double, 6, 6> H;
  H.topLeftCorner<3, 3>() = 2 * (v.squaredNorm() * I - v * v.transpose());
  H.bottomRightCorner<3, 3>() = 2 * (u.squaredNorm() * I - u * u.transpose());
  H.topRightCorner<3, 3>() = 2 * (2 * u * v.transpose() - uv * I - v * u.transpose());
  H.bottomLeftCorner<3, 3>() = H.topRightCorner<3, 3>().transpose();
  const double first = 2 * (1 - z) / e, second = -2 / (e * e);
  // u = x1 - x0, v = x3 - x2
  Eigen::Matrix<double, 12, 6> E = Eigen::Matrix<double, 12, 6>::Zero();
  for (int k = 0; k < 2; ++k) {
    E.block<3, 3>(6 * k, 3 * k) = -I;
    E.block<3, 3>(6 * k + 3, 3 * k) = I;
  }
  gradient = first * (E * dy);
  hessian = E * (second * dy * dy.transpose() + first * H) * E.transpose();
}

}  // namespace sim
