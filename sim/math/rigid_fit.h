// The rotation and translation that bring points p onto points q as nearly as they can: sum m_i |q_i - R p_i - t|^2 is
// least. [Kabsch 1976]
#pragma once

#include <Eigen/Core>
#include <vector>

namespace sim {

struct RigidFit {
  Eigen::Matrix3d R;
  Eigen::Vector3d p_mean, q_mean;
  Eigen::Vector3d place(const Eigen::Vector3d& p) const { return q_mean + R * (p - p_mean); }
};

// Over the points `nodes`, with weights m > 0. D = 2: points in the plane z = 0, turned about z only.
RigidFit fit_rigid(const Eigen::Matrix3Xd& p, const Eigen::Matrix3Xd& q, const Eigen::VectorXd& m,
                   const std::vector<int>& nodes, int D);

}  // namespace sim
