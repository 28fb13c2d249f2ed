#include "sim/study/bar.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "sim/study/modes.h"

namespace sim {

// theta = (2k - 1) pi/(2n):  exact (2k - 1) pi c/(2L);  consistent (c/h) sqrt(6 (1 - cos theta)/(2 + cos theta));
// lumped (2c/h) sin(theta/2). [Hughes 1987, 9.3]
BarFrequencies bar_frequencies(double L, double young, double density, int n, int k) {
  const double c = std::sqrt(young / density), h = L / n;
  const double theta = (2 * k - 1) * std::numbers::pi / (2 * n);
  return {theta * n * c / L, c / h * std::sqrt(6 * (1 - std::cos(theta)) / (2 + std::cos(theta))),
          2 * c / h * std::sin(theta / 2)};
}

BarModes bar_modes(const Scene& scene, std::size_t body, int count) {
  const Mesh& mesh = scene.bodies[body].mesh;
  const Modes all = vibration_modes(scene, body, 2 * mesh.node_count());
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index k = 0; k < all.omega.size() && std::ssize(chosen) < count; ++k) {
    const auto u = all.shape.col(k).reshaped(2, mesh.node_count());
    double apart = 0;
    for (int i = 0; i < mesh.node_count(); ++i)
      for (int j = 0; j < i; ++j)
        if (std::abs(mesh.X(0, i) - mesh.X(0, j)) < 1e-9 * mesh.X.row(0).maxCoeff())
          apart = std::max(apart, (u.col(i) - u.col(j)).norm());
    if (apart < 1e-6 * u.cwiseAbs().maxCoeff()) chosen.push_back(k);
  }
  BarModes modes{Eigen::VectorXd(std::ssize(chosen)), Eigen::MatrixXd(all.shape.rows(), std::ssize(chosen))};
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    modes.omega[static_cast<Eigen::Index>(k)] = all.omega[chosen[k]];
    modes.shape.col(static_cast<Eigen::Index>(k)) = all.shape.col(chosen[k]);
  }
  return modes;
}

}  // namespace sim
