#include "sim/study/sag.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "sim/build/parts.h"

namespace sim {

double expected_sag(const System& system, std::size_t b, const Vec3& gravity) {
  const BodyRange& range = system.bodies()[b];
  const Eigen::MatrixXd& X = range.mesh->X;
  Eigen::AlignedBox3d held;
  for (const int node : system.pinned_nodes(0)) {
    const int own = node - range.first_node;
    if (own >= 0 && own < range.node_count) held.extend(Vec3(X.col(own)));
  }
  if (held.isEmpty()) return 0;
  const Vec3 down = gravity.normalized();
  double L = 0;
  for (const auto& point : X.colwise()) {
    const Vec3 arm = Vec3(point) - Vec3(point).cwiseMax(held.min()).cwiseMin(held.max());
    L = std::max(L, (arm - arm.dot(down) * down).norm());
  }
  const double H = (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).minCoeff();
  const MaterialSpec& material = parts_of(system).model.bodies[b].materials.front();
  const double rho_g = material.density * gravity.norm();
  return H > 0 ? std::min(L, 2 * 1.5 * rho_g * L * L * L * L / (material.young * H * H)) : L;
}

}  // namespace sim
