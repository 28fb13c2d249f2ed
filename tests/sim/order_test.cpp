// Every scheme's order in time, by halving the step on a smooth start.
#include "tests/sim/stepping.h"

namespace sim {
namespace {

// Positions and velocities. (Positions alone converge faster in symplectic Euler: they are those of velocity Verlet.)
Eigen::VectorXd after_half_a_second(const std::string& integrator, int substeps) {
  test::Stepped run(test::plate(integrator, substeps));
  run.steps(15 * substeps);
  Eigen::VectorXd both(2 * run.state.x.size());
  both << run.state.x, run.state.v;
  return both;
}

double measured_order(const Scheme& scheme) {
  // Explicit schemes need small steps to be stable at all.
  const int n = scheme.is_explicit() ? 16 : 4;
  const std::string name(scheme.name);
  const Eigen::VectorXd a = after_half_a_second(name, n), b = after_half_a_second(name, 2 * n),
                        c = after_half_a_second(name, 4 * n);
  return std::log2((a - b).norm() / (b - c).norm());
}

TEST(Order, OfEverySchemeInTime) {
  for (const Scheme& scheme : schemes()) {
    if (scheme.is_static) continue;
    EXPECT_NEAR(measured_order(scheme), scheme.order, 0.15) << scheme.name;
  }
}

// The schemes meet in one limit, and a coefficient that is wrong keeps a scheme from it.
TEST(Order, SchemesOfSecondOrderMeet) {
  const Eigen::VectorXd reference = after_half_a_second("tr-bdf2", 64);
  for (const Scheme& scheme : schemes())
    if (scheme.order == 2) {
      EXPECT_LT((after_half_a_second(std::string(scheme.name), 64) - reference).norm(), 2e-4) << scheme.name;
    }
}

// Stiffness damping frozen at the step's start costs an order; evaluated anew at the stage's solution it does not.
TEST(Order, OfBetaDampingFrozenAndEvaluatedAnew) {
  const auto order = [](int lag_iterations) {
    const auto run = [&](int substeps) {
      Scene scene = test::plate("sdirk2", substeps);
      scene.bodies[0].damping = {0, 0.05};
      scene.bodies[0].loads.tractions[0].value = {0, 3000, 0};
      scene.solver.lag_iterations = lag_iterations;
      test::Stepped stepped(scene);
      stepped.steps(15 * substeps);
      return stepped.state.x;
    };
    const Eigen::VectorXd a = run(4), b = run(8), c = run(16);
    return std::log2((a - b).norm() / (b - c).norm());
  };
  const double frozen = order(0), anew = order(1);
  std::printf("order of sdirk2 with beta damping: frozen %.2f, evaluated anew %.2f\n", frozen, anew);
  EXPECT_NEAR(frozen, 1, 0.25);
  EXPECT_NEAR(anew, 2, 0.25);
}

TEST(Momentum, IsKeptInFreeFlightByEveryScheme) {
  for (const Scheme& scheme : schemes()) {
    if (scheme.is_static) continue;
    Scene scene = test::free_body({"tet4", false}, "stable-neo-hookean");
    scene.bodies[0].velocity = {1, 2, -0.5};
    scene.bodies[0].spin = {{0.3, 1, 0.2}, 4};
    scene.time.integrator = std::string(scheme.name);
    scene.time.substeps = 8;
    scene.solver.tolerance = 1e-12;
    test::Stepped run(scene);
    const Vec3 p = run.system.measure(run.state).p;
    const double mv = p.norm();
    run.steps(100);
    EXPECT_LT((run.system.measure(run.state).p - p).norm(), 1e-10 * mv) << scheme.name;

    scene.solver.tolerance = Solver().tolerance;
    test::Stepped loose(scene);
    loose.steps(100);
    std::printf("%s at the default tolerance: |dp| = %.1e m v after 100 steps\n", std::string(scheme.name).c_str(),
                (loose.system.measure(loose.state).p - p).norm() / mv);
  }
}

// Angular momentum: kept to round-off by the explicit schemes and the implicit midpoint rule.
TEST(Momentum, AngularIsKeptByTheSchemesThatShould) {
  for (const char* name : {"symplectic-euler", "central-difference", "implicit-midpoint"}) {
    Scene scene = test::free_body({"tet4", false}, "stable-neo-hookean");
    scene.bodies[0].spin = {{0.3, 1, 0.2}, 4};
    scene.time.integrator = name;
    scene.time.substeps = 8;
    scene.solver.tolerance = 1e-12;
    test::Stepped run(scene);
    const Vec3 L = run.system.measure(run.state).L;
    run.steps(100);
    EXPECT_LT((run.system.measure(run.state).L - L).norm(), 1e-9 * L.norm()) << name;
  }
}

// Energy of a vibrating body without load: the schemes in the order that theory gives.
TEST(Energy, BackwardEulerLosesMostTheOthersLittle) {
  const auto lost = [](const char* name) {
    Scene scene = test::plate(name, 1);
    scene.bodies[0].loads.tractions.clear();
    scene.bodies[0].velocity = {0, 0.5, 0};
    test::Stepped run(scene);
    const Measures before = run.system.measure(run.state);
    run.steps(60);
    const Measures after = run.system.measure(run.state);
    return 1 - (after.kinetic + after.elastic) / (before.kinetic + before.elastic);
  };
  const double euler = lost("backward-euler"), tr_bdf2 = lost("tr-bdf2"), sdirk2 = lost("sdirk2"),
               trapezoidal = lost("trapezoidal"), midpoint = lost("implicit-midpoint");
  std::printf("energy lost in 2 s: backward-euler %.3f, sdirk2 %.4f, tr-bdf2 %.4f, trapezoidal %.2e, midpoint %.2e\n",
              euler, sdirk2, tr_bdf2, trapezoidal, midpoint);
  EXPECT_GT(euler, 0.2);
  EXPECT_LT(sdirk2, 0.5 * euler);
  EXPECT_LT(tr_bdf2, 0.5 * euler);
  EXPECT_LT(std::abs(trapezoidal), 1e-3);
  EXPECT_LT(std::abs(midpoint), 1e-3);
}

}  // namespace
}  // namespace sim
