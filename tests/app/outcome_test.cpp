// What a run adds up over its steps, and what is said of it at its end.
#include "app/run/outcome.h"

#include "app/base/exit_code.h"
#include "tests/app/session_scene.h"

namespace app {
namespace {

constexpr const char* tip_probe = "[[probe]]\nname = \"tip\"\nbody = \"beam\"\nat = [2, 0.5, 0.5]\n";

class OutcomeTest : public SessionScene {
 protected:
  struct Said {
    int code = 0;
    std::string out, err;
  };

  // A scene with a probe, and a run of it that has come to step 8 without a word.
  OutcomeTest() {
    write_all(folder_ / "probed.toml", std::string(session_beam) + tip_probe + "reference = [0.02, 0, -0.05]\n");
    simulation_ = build_simulation(options("probed.toml"));
    outcome_.status = Status::done;
    outcome_.run.state = simulation_.system->initial_state();
    outcome_.run.state.step = 8;
  }
  Said concluded(bool quiet = false) const {
    Options with = options();
    with.quiet = quiet;
    const RunFolder folder(folder_ / "out", Existing::refuse);
    Said said;
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    said.code = conclude(simulation_, with, folder, outcome_);
    said.err = testing::internal::GetCapturedStderr();
    said.out = testing::internal::GetCapturedStdout();
    return said;
  }

  Simulation simulation_;
  Outcome outcome_;
};

sim::StepReport taken(int newton, int splits, double min_J) {
  sim::StepReport report;
  report.newton = newton;
  report.linear = 10 * newton;
  report.splits = splits;
  report.min_J = min_J;
  report.seconds = 4;
  report.seconds_assemble = 2;
  report.seconds_solve = 1;
  return report;
}

TEST(OutcomeAdd, SumsSteps) {
  Outcome outcome;
  sim::StepReport first = taken(3, 0, 0.9), second = taken(5, 2, 0.4), third = taken(1, 1, 0.7);
  first.inverted = 6;
  second.converged = third.converged = false;
  second.reason = "the first reason";
  third.reason = "the second reason";
  third.inverted = 4;
  second.no_factor = true;
  for (const sim::StepReport& report : {first, second, third}) EXPECT_TRUE(outcome.add(report));
  const Totals& totals = outcome.run.totals;
  EXPECT_EQ(totals.newton, 9);
  EXPECT_EQ(totals.linear, 90);
  EXPECT_EQ(totals.splits, 3);
  EXPECT_EQ(totals.not_converged, 2);
  EXPECT_EQ(totals.min_J, 0.4);
  EXPECT_EQ(outcome.inverted, 4) << "after the last step";
  EXPECT_EQ(outcome.not_converged_reason, "the first reason");
  EXPECT_TRUE(outcome.no_factor) << "once is enough";
  EXPECT_EQ(outcome.stepping, 12);
  EXPECT_EQ(outcome.assembling, 6);
  EXPECT_EQ(outcome.solving, 3);
}

// Its seconds were spent; all else is of the steps that were taken.
TEST(OutcomeAdd, AStepThatCannotBeTakenIsNotCounted) {
  Outcome outcome;
  EXPECT_TRUE(outcome.add(taken(3, 0, 0.9)));
  sim::StepReport bad = taken(5, 2, -1);
  bad.failure = "the forces are not finite";
  bad.inverted = 7;
  EXPECT_FALSE(outcome.add(bad));
  EXPECT_EQ(outcome.run.totals.newton, 3);
  EXPECT_EQ(outcome.run.totals.splits, 0);
  EXPECT_EQ(outcome.run.totals.min_J, 0.9);
  EXPECT_EQ(outcome.inverted, 0);
  EXPECT_EQ(outcome.failure.failure, "the forces are not finite");
  EXPECT_EQ(outcome.stepping, 8);
}

TEST_F(OutcomeTest, NothingIsSaidOfARunThatWentWell) {
  const Said said = concluded();
  EXPECT_EQ(said.code, exit_done);
  EXPECT_EQ(said.err, "");
}

TEST_F(OutcomeTest, EachTroubleHasItsNote) {
  const auto noted = [&](const Outcome& trouble) {
    outcome_ = trouble;
    EXPECT_EQ(concluded(true).err, "") << "quiet";
    const Said said = concluded();
    EXPECT_EQ(said.code, exit_done) << "the run went on";
    return said.err;
  };
  const Outcome smooth = outcome_;
  Outcome unsolved = smooth, halved = smooth, inverted = smooth, factor = smooth;
  unsolved.run.totals.not_converged = 2;
  EXPECT_EQ(noted(unsolved), "note: 2 of 8 steps did not converge\n");
  unsolved.not_converged_reason = "solver.max_iterations reached";
  EXPECT_EQ(noted(unsolved), "note: 2 of 8 steps did not converge (solver.max_iterations reached)\n");
  halved.run.totals.splits = 3;
  EXPECT_EQ(noted(halved), "note: steps, or parts of them, were taken again in halves 3 times\n");
  inverted.inverted = 4;
  EXPECT_EQ(noted(inverted), "note: 4 elements are inside out at the end\n");
  factor.no_factor = true;
  EXPECT_EQ(noted(factor),
            "note: there was no memory for the matrix's factor: solved by conjugate gradients without a matrix\n");
}

// The body is moved as a whole, so that the displacement of the probe is known.
TEST_F(OutcomeTest, AProbeWithAReferenceSaysHowFarItIsFromIt) {
  sim::State& state = outcome_.run.state;
  for (Eigen::Index i = 0; i < state.x.size(); i += 3) state.x.segment<3>(i) += sim::Vec3(0.025, 0.3, -0.04);
  EXPECT_EQ(concluded().out,
            "tip.ux = 0.025 m, reference 0.02 m, error 25 %\ntip.uz = -0.04 m, reference -0.05 m, error -20 %\n");
  outcome_.status = Status::interrupted;
  EXPECT_EQ(concluded().out, "") << "it holds for the end of the scene";
}

TEST_F(OutcomeTest, AnInterruptedRunSaysHowItIsGoneOnWith) {
  outcome_.status = Status::interrupted;
  const Said said = concluded(true);
  EXPECT_EQ(said.code, exit_interrupted);
  EXPECT_EQ(said.err, "ritz: interrupted after step 8 of 20; go on with --resume " + (folder_ / "out").string() + "\n");
}

TEST_F(OutcomeTest, AFailedRunSaysWhereWhyAndWhatIsSaved) {
  outcome_.status = Status::failed;
  outcome_.failure.step = 9;
  outcome_.failure.min_J_element = 17;
  outcome_.failure.failure = "the forces are not finite";
  const std::string saved = "\n      the last good state is saved in " + (folder_ / "out/state.bin").string() + "\n";
  Said said = concluded(true);
  EXPECT_EQ(said.code, exit_numerical_failure);
  EXPECT_EQ(said.err, "ritz: step 9, t = 0.225 s, element 17: the forces are not finite" + saved);
  outcome_.failure = {};
  outcome_.error = "frame_00003.png: No space left on device";
  said = concluded(true);
  EXPECT_EQ(said.code, exit_numerical_failure);
  EXPECT_EQ(said.err, "ritz: frame_00003.png: No space left on device" + saved);
}

}  // namespace
}  // namespace app
