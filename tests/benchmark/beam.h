// The beam of the benchmarks: 4 x 1 x 1 m, 4n x n x n cells of six tets, E = 1e6 Pa, nu = 0.45, gravity.
#pragma once

#include "tests/sim/stepping.h"

namespace benchmarks {

inline sim::Scene beam(int n, const std::string& model) {
  sim::Scene scene = sim::test::beam("tet4", n);
  scene.bodies[0].materials[0].model = model;
  return scene;
}

// As it hangs after half a second, about: bent into an arc of radius 4 m (strains to 12 per cent), with a disturbance
// of 0.2 per cent of a cell, so that no two elements are alike.
inline Eigen::VectorXd bent(const Eigen::VectorXd& X) {
  constexpr double radius = 4;
  Eigen::VectorXd x = X;
  for (Eigen::Index i = 0; i < x.size(); i += 3) {
    const double angle = X[i] / radius, arm = radius + X[i + 2] - 0.5;
    x[i] = arm * std::sin(angle);
    x[i + 2] = arm * std::cos(angle) - radius;
    for (int c = 0; c < 3; ++c) x[i + c] += 2.5e-4 * std::sin(2.0 * static_cast<double>((i + c) % 977));
  }
  return x;
}

}  // namespace benchmarks
