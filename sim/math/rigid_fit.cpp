#include "sim/math/rigid_fit.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace sim {

RigidFit fit_rigid(const Eigen::Matrix3Xd& p, const Eigen::Matrix3Xd& q, const Eigen::VectorXd& m,
                   const std::vector<int>& nodes, int D) {
  double mass = 0;
  for (const int i : nodes) mass += m[i];
  RigidFit fit{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (const int i : nodes) {
    fit.p_mean += m[i] / mass * p.col(i);
    fit.q_mean += m[i] / mass * q.col(i);
  }
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  for (const int i : nodes) H += m[i] / mass * (q.col(i) - fit.q_mean) * (p.col(i) - fit.p_mean).transpose();
  const double scale = H.norm();
  if (!(scale > 0)) return fit;
  H /= scale;
  if (D == 2) H(2, 2) = 2;  // more than any other singular value: z stays z
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  fit.R = svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
  return fit;
}

}  // namespace sim
