// The beam of the benchmarks: 4 x 1 x 1 m, 4n x n x n cells of six tets, E = 1e6 Pa, nu = 0.45, gravity.
#pragma once

#include "tests/sim/stepping.h"

namespace benchmarks {

inline sim::Scene beam(int n, const std::string& model) {
  sim::Scene scene = sim::test::beam("tet4", n);
  scene.bodies[0].materials[0].model = model;
  return scene;
}

// Bent and squashed by a few per cent, so that nothing is at rest.
inline Eigen::VectorXd bent(const Eigen::VectorXd& X) {
  Eigen::VectorXd x = X;
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] += 0.02 * std::sin(2.0 * static_cast<double>(i % 977));
  return x;
}

}  // namespace benchmarks
