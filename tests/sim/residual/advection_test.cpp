// Advection and diffusion: the lecture's problem that is not self-adjoint.
#include "sim/residual/advection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/residual/method.h"
#include "tests/sim/residual/problems.h"

namespace sim::residual {
namespace {

TEST(Advection, IsTheProblemOfTheTable) {
  for (const Real eps : {1.0L, 0.1L, 0.01L}) {
    const Problem problem = advection_diffusion(eps), table = test::problem_c(eps);
    for (int i = 0; i <= 20; ++i) {
      const Real x = i / 20.0L;
      EXPECT_NEAR(problem.exact(x).value, table.exact(x).value, 1e-16);
      EXPECT_NEAR(problem.exact(x).slope, table.exact(x).slope, 1e-14);
      EXPECT_EQ(problem.k(x).value, table.k(x).value);
      EXPECT_EQ(problem.f(x).value, table.f(x).value);
    }
  }
}

// -eps u'' + u' = 1 by differences of u'; for a large eps, u = x (1 - x)/(2 eps).
TEST(Advection, ItsSolutionSolvesIt) {
  const Real h = 1e-5L;
  for (const Real eps : {5.0L, 1.0L, 0.05L}) {
    const Function u = advection_diffusion(eps).exact;
    for (const Real x : {0.2L, 0.5L, 0.9L}) {
      const Real curvature = (u(x + h).slope - u(x - h).slope) / (2 * h);
      EXPECT_NEAR(-eps * curvature + u(x).slope, 1, 1e-6);
      EXPECT_NEAR((u(x + h).value - u(x - h).value) / (2 * h), u(x).slope, 1e-6);
    }
  }
  EXPECT_NEAR(1e9L * advection_diffusion(1e9L).exact(0.5L).value, 0.125, 1e-8);
}

// Up to a cell Peclet number of 1 nothing is above u = x; beyond it the nodes swing about that line.
TEST(Advection, NodesOvershootFromAPecletNumberOfOneOn) {
  for (const auto& row : test::rows_of("peclet.csv")) {
    const Real eps = std::stold(row[0]);
    const int n = std::stoi(row[1]);
    EXPECT_NEAR(cell_peclet(eps, n) / std::stold(row[2]), 1, 1e-9);
  }
  const auto above = [](Real peclet, int n) {
    return overshoot(galerkin(advection_diffusion(1 / (2 * peclet * (n + 1))), *find_basis("hats"), n).c);
  };
  for (const int n : {4, 8}) {
    for (const Real peclet : {0.3L, 0.9L, 1.0L}) EXPECT_LT(above(peclet, n), 1e-15) << peclet;
    EXPECT_GT(above(1.01L, n), 1e-3);
    EXPECT_GT(above(3, n), above(2, n));
  }
  // -0.396, 0.532, -0.158, 1.130 at a Peclet number of 10
  EXPECT_NEAR(above(10, 4), 1.130395275 - 0.8, 1e-9);
}

}  // namespace
}  // namespace sim::residual
