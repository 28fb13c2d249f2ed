// How steps with contact are solved: the same bits, the same place by every solver, few iterations.
#include "tests/sim/contact_support.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

TEST(ContactSolves, SameBitsForAnyThreads) {
  const Scene scene = test::two_boxes(3, 0.005);
  test::Stepped one(scene, 1), two(scene, 2);
  one.steps(8);
  two.steps(8);
  EXPECT_EQ(hash(one.state), hash(two.state));
}

// From a state that was saved, bodies being in contact, the run goes on with the same bits.
TEST(ContactSolves, ResumesToTheSameBits) {
  for (const auto& [linear, name] : choices<LinearSolverKind>) {
    Scene scene = test::two_boxes(2, 0.005);
    scene.solver.linear = linear;
    scene.contacts[0].friction = 0.3;
    test::Stepped through(scene);
    through.steps(8);
    const State saved = through.state;
    through.steps(6);
    test::Stepped resumed(scene);
    resumed.state = saved;
    resumed.steps(6);
    EXPECT_EQ(hash(through.state), hash(resumed.state)) << name;
  }
}

// The sharp edges of boxes that lie turned across each other carry most of the load between them.
TEST(ContactSolves, CrossingEdgesTakeFewIterations) {
  Scene scene = test::two_boxes(4, 0.5);
  scene.bodies[1] = test::box_body("top", {1, 1, 1}, 4, {0, 0, 0});
  rotate(scene.bodies[1].mesh, {0, 1, 0}, 20);
  translate(scene.bodies[1].mesh, {0.1, 1.5, 0.15});
  test::Stepped run(scene);
  int most = 0;
  for (int k = 0; k < 40; ++k) {
    run.steps(1);
    most = std::max(most, run.last.newton);
    ASSERT_EQ(test::count_crossings(scene, run.state.x), 0) << "step " << k;
  }
  EXPECT_LT(most, 45);
}

// Whatever solves the linear systems, which see pairs that no element couples.
TEST(ContactSolves, SolversAgree) {
  Scene scene = test::two_boxes(2, 0.005);
  scene.solver.tolerance = 1e-8;
  Eigen::VectorXd first;
  for (const auto& [linear, name] : choices<LinearSolverKind>) {
    scene.solver.linear = linear;
    test::Stepped run(scene);
    run.steps(6);
    EXPECT_GT(run.system.contacts(run.state)[0].pairs, 0);
    if (first.size() == 0) first = run.state.x;
    EXPECT_LT((run.state.x - first).cwiseAbs().maxCoeff(), 1e-7) << name;
  }
}

// A solve takes hardly more iterations where bodies touch than where they do not.
TEST(ContactSolves, TouchingCostsFewIterationsOfTheLinearSolver) {
  Scene scene = test::two_boxes(4, 0.005);
  scene.solver.linear = LinearSolverKind::two_level;
  double iterations[2];
  for (const bool touching : {false, true}) {
    if (!touching) translate(scene.bodies[1].mesh, {0, 20, 0});
    test::Stepped run(scene);
    int linear = 0, newton = 0;
    for (int k = 0; k < 8; ++k) {
      run.steps(1);
      linear += run.last.linear;
      newton += run.last.newton;
    }
    EXPECT_EQ(run.system.contacts(run.state)[0].pairs > 0, touching);
    iterations[touching] = static_cast<double>(linear) / newton;
    if (!touching) translate(scene.bodies[1].mesh, {0, -20, 0});
  }
  EXPECT_LT(iterations[1], 2 * iterations[0]);
}

}  // namespace
}  // namespace sim
