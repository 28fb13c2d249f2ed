// When a solver keeps what it holds, when it makes it anew, and when "auto" changes from one solver to the other.
#include "tests/sim/stepping.h"

namespace sim {
namespace {

Kept held(const State& state) {
  return static_cast<Kept>(state.kept.what);
}

// Nearly incompressible: a coarse level of rigid motions does not know of volume, and iterations are many.
Scene incompressible() {
  return test::beam("tet4", 5, 1e6, 0.4995);
}

TEST(TwoLevelSolver, TakesFewerIterationsThanOneLevel) {
  Scene scene = test::beam("tet4", 8);
  int iterations[2];
  for (const bool two : {false, true}) {
    scene.solver.linear = two ? LinearSolverKind::two_level : LinearSolverKind::pcg_assembled;
    test::Stepped run(scene);
    iterations[two] = 0;
    for (int k = 0; k < 4; ++k) {
      run.steps(1);
      iterations[two] += run.last.linear;
    }
    EXPECT_EQ(held(run.state), two ? Kept::coarse : Kept::nothing);
  }
  EXPECT_LT(1.7 * iterations[1], iterations[0]);
}

TEST(TwoLevelSolver, KeepsTheCoarseLevelFromStepToStep) {
  Scene scene = test::beam("tet4", 4);
  scene.solver.linear = LinearSolverKind::two_level;
  test::Stepped run(scene);
  run.steps(2);
  const Eigen::VectorXd made_at = run.state.kept.x;
  const std::int64_t solves = run.state.kept.solves;
  run.steps(1);
  EXPECT_EQ(run.state.kept.x, made_at);
  EXPECT_GT(run.state.kept.solves, solves);
  run.state.kept.excess = 1000;  // worn out
  run.steps(1);
  EXPECT_NE(run.state.kept.x, made_at);
  EXPECT_LT(run.state.kept.excess, 1000);
}

TEST(TwoLevelSolver, ResumesToTheSameBitsAfterPinsAreReleased) {
  Scene scene = test::beam("tet4", 3);
  scene.solver.linear = LinearSolverKind::two_level;
  scene.bodies[0].pins[0].release = 4.5 / 60;
  scene.bodies[0].damping = {0.1, 1e-3};
  for (const int saved_at : {3, 4, 5, 7}) {
    test::Stepped straight(scene), resumed(scene);
    straight.steps(saved_at);
    resumed.state = straight.state;
    straight.steps(6);
    resumed.steps(6);
    EXPECT_EQ(hash(straight.state), hash(resumed.state)) << saved_at;
  }
}

// A squashed body with its exact, indefinite tangents.
TEST(TwoLevelSolver, SeesNegativeCurvature) {
  Scene scene = test::beam("tet4", 3);
  scene.solver.linear = LinearSolverKind::two_level;
  scene.bodies[0].start.shape = "squashed";
  scene.bodies[0].start.amount = 0.7;
  scene.solver.definiteness = Definiteness::none;
  Scene safe = scene;
  safe.solver.definiteness = Definiteness::clamp;
  test::Stepped run(scene), same(safe);
  run.steps(5);
  same.steps(5);
  EXPECT_LT((run.state.x - same.state.x).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(AutoSolver, StaysWithTwoLevelsWhereTheyTakeFewIterations) {
  test::Stepped run(test::beam("tet4", 5));
  run.steps(5);
  EXPECT_EQ(held(run.state), Kept::coarse);
  EXPECT_EQ(run.last.factorisations, 0);
}

TEST(AutoSolver, GoesOverToCholmodAndBack) {
  test::Stepped run(incompressible());
  run.steps(2);
  ASSERT_EQ(held(run.state), Kept::factor);
  EXPECT_GE(run.state.kept.fresh, 80) << "what the two levels took";
  State worn = run.state;
  worn.kept.excess = 1'000'000;
  worn.kept.fresh = 1;  // one iteration on two levels would have done
  run.state = worn;
  const StepReport report = run.stepper->step(run.state);
  EXPECT_TRUE(report.converged);
  EXPECT_GE(report.linear, 80) << "they are tried again";
}

TEST(AutoSolver, ResumesToTheSameBitsWithEither) {
  for (const Scene& scene : {test::beam("tet4", 3), incompressible()}) {
    test::Stepped straight(scene), resumed(scene);
    straight.steps(3);
    resumed.state = straight.state;
    straight.steps(3);
    resumed.steps(3);
    EXPECT_EQ(hash(straight.state), hash(resumed.state));
  }
}

}  // namespace
}  // namespace sim
