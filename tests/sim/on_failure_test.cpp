// What is done with a step whose equations are not solved.
#include <cmath>

#include "sim/build/build.h"
#include "sim/term/term.h"
#include "sim/time/implicit.h"
#include "tests/sim/stepping.h"

namespace sim::test {
namespace {

// A step that needs more iterations than it is given.
Scene hard_step(OnFailure on_failure) {
  Scene scene = block("stable-neo-hookean", "backward-euler", "stretched", 1);
  scene.bodies[0].start.amount = 2;
  scene.solver.max_iterations = 4;
  scene.solver.on_failure = on_failure;
  return scene;
}

// A term without a force, with which the equations of no step longer than `longest` [s] can be solved.
class Haste final : public Term {
 public:
  explicit Haste(double longest) : longest_(longest) {}
  TermInfo info() const override { return {"haste", ""}; }
  Role role() const override { return Role::applied; }
  double energy(const Motion&, Store&) const override { return 0; }
  void add_forces(const Motion& motion, Store&, Eigen::VectorXd& f) const override {
    if (motion.dv_dx * longest_ < 1 && motion.dv_dx > 0) f[0] = std::nan("");
  }

 private:
  double longest_;
};

// A stretched block after a step that must be taken in so many parts.
struct Hurried {
  State state;
  StepReport report;

  explicit Hurried(int parts) {
    const Scene scene = block("stable-neo-hookean", "backward-euler", "stretched", 1);
    state = System(scene).initial_state();
    const std::unique_ptr<Parts> built = build(scene, 1);
    built->model.terms.push_back(std::make_unique<Haste>(1.01 * built->model.h() / parts));
    report = ImplicitStepper(built->model, *built->scheme, 1).step(state);
  }
};

// Where it is, is where a run with the shorter steps would be.
TEST(OnFailure, SplitTakesTheStepInHalvesAndCountsThem) {
  for (const int parts : {1, 2, 4, 8, 16}) {
    const Hurried halved(parts);
    EXPECT_EQ(halved.report.failure, "");
    EXPECT_TRUE(halved.report.converged);
    EXPECT_EQ(halved.report.splits, parts - 1);
    EXPECT_EQ(halved.state.step, 1);
    Scene fine = block("stable-neo-hookean", "backward-euler", "stretched", 1);
    fine.time.substeps = parts;
    Stepped shorter(fine);
    shorter.steps(parts);
    EXPECT_LT((halved.state.x - shorter.state.x).norm(), 1e-9) << parts;
    EXPECT_LT((halved.state.v - shorter.state.v).norm(), 1e-7) << parts;
  }
}

TEST(OnFailure, SplitEndsAtSixteenthsAndLeavesTheStateAsItWas) {
  const Hurried stopped(32);
  EXPECT_EQ(stopped.report.failure, "the forces or the Newton direction are not finite");
  EXPECT_EQ(stopped.report.splits, 4);
  EXPECT_EQ(hash(stopped.state), hash(Stepped(block("stable-neo-hookean", "backward-euler", "stretched", 1)).state));
}

// Too few iterations, that all make progress, are not mended by shorter steps: a cap bounds what a step costs.
TEST(OnFailure, ACapOfIterationsIsNotSplit) {
  Stepped split(hard_step(OnFailure::split)), accept(hard_step(OnFailure::accept));
  const StepReport report = split.stepper->step(split.state);
  accept.stepper->step(accept.state);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.splits, 0);
  EXPECT_EQ(report.newton, 4);
  EXPECT_EQ(hash(split.state), hash(accept.state));
}

TEST(OnFailure, AcceptGoesOnAndSaysSo) {
  Stepped run(hard_step(OnFailure::accept));
  const StepReport report = run.stepper->step(run.state);
  EXPECT_EQ(report.failure, "");
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.reason, "solver.max_iterations reached");
  EXPECT_EQ(report.splits, 0);
  EXPECT_EQ(report.newton, 4);
  EXPECT_EQ(run.state.step, 1);
}

TEST(OnFailure, StopLeavesTheStateAsItWas) {
  Stepped run(hard_step(OnFailure::stop));
  const State before = run.state;
  const StepReport report = run.stepper->step(run.state);
  EXPECT_EQ(report.failure, "the step did not converge: solver.max_iterations reached");
  EXPECT_EQ(hash(run.state), hash(before));
  EXPECT_GE(report.min_J_element, 0);
}

}  // namespace
}  // namespace sim::test
