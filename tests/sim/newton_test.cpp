// What Newton's method does where energies are hardly told apart, where its tangent is too stiff, and when it ends.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/build/build.h"
#include "sim/solve/exactness.h"
#include "sim/solve/progress.h"
#include "sim/term/term.h"
#include "sim/time/implicit.h"
#include "tests/sim/stepping.h"

namespace sim::test {
namespace {

using Kind = Progress::Kind;

TEST(Progress, AnIterationThatFallsOrShortensItsStepsGoesOn) {
  Progress falls, shortens;
  for (int k = 0; k < 500; ++k) {
    EXPECT_EQ(falls.look(1, 100, 1, 1e-9), Kind::made);
    EXPECT_EQ(shortens.look(0, 100, std::pow(0.9, k), 1e-9), Kind::made);
  }
}

TEST(Progress, FifteenIterationsWithoutEitherEndIt) {
  Progress progress;
  progress.look(0, 100, 1, 1e-9);
  for (int k = 1; k < 15; ++k) ASSERT_EQ(progress.look(0.01, 100, 1, 1e-9), Kind::made) << k;
  EXPECT_EQ(progress.look(0.01, 100, 1, 1e-9), Kind::none);
}

TEST(Progress, WhereRoundOffIsAllThatIsLeftItSaysSo) {
  Progress idle;
  for (int k = 0; k < 15; ++k) idle.look(0, 1e-9, 1, 1e-9);
  EXPECT_EQ(idle.look(0, 1e-9, 1, 1e-9), Kind::round_off);
  // Falls that are real, each of a few times the round-off.
  Progress creeps;
  Kind last = Kind::made;
  int k = 0;
  for (; k < 200 && last == Kind::made; ++k) last = creeps.look(5e-9, 6e-9, 1, 1e-9);
  EXPECT_EQ(last, Kind::round_off);
  EXPECT_EQ(k, 100);
}

// A spring from each component to where it starts, k/2 |x - x_0|^2, with a tangent and an energy that may be wrong.
class Tether final : public Term {
 public:
  Tether(double k, double too_stiff, double noise) : k_(k), too_stiff_(too_stiff), noise_(noise) {}
  TermInfo info() const override { return {"tether", ""}; }
  Role role() const override { return Role::applied; }
  double energy(const Motion& motion, Store&) const override {
    // As good as random: the last bits of a position.
    return 0.5 * k_ * motion.x.squaredNorm() + noise_ * std::sin(1e15 * motion.x[0]);
  }
  void add_forces(const Motion& motion, Store&, Eigen::VectorXd& f) const override { f -= k_ * motion.x; }
  void add_product(const Store&, double s, const Eigen::VectorXd& p, Eigen::VectorXd& y) const override {
    y += s * too_stiff_ * k_ * p;
  }
  void add_diagonal(const Store&, double s, Eigen::VectorXd& d) const override { d.array() += s * too_stiff_ * k_; }

 private:
  double k_, too_stiff_, noise_;
};

StepReport step_with(double k, double too_stiff, double noise) {
  Scene scene = block("stable-neo-hookean", "backward-euler", "stretched", 1);
  scene.bodies[0].start.amount = 1.5;
  scene.solver.linear = LinearSolverKind::pcg;
  scene.solver.tolerance = 1e-6;
  scene.solver.on_failure = OnFailure::accept;
  State state = System(scene).initial_state();
  const std::unique_ptr<Parts> built = build(scene, 1);
  built->model.terms.push_back(std::make_unique<Tether>(k, too_stiff, noise));
  return ImplicitStepper(built->model, *built->scheme, 1).step(state);
}

// An energy whose round-off is thousands of times what it is taken for hides the fall of the last iterations; their
// slopes do not.
TEST(Newton, SlopesTellWhereRoundOffHidesTheFall) {
  const StepReport quiet = step_with(1e5, 1, 0), noisy = step_with(1e5, 1, 1e-5);
  EXPECT_TRUE(quiet.converged);
  EXPECT_TRUE(noisy.converged) << noisy.reason;
  EXPECT_LE(noisy.newton, quiet.newton + 2);
}

// A tangent that is a hundred times too stiff leaves 0.99 of the error in an iteration; longer steps do not.
TEST(Newton, StepsAreLongerWhereTheTangentIsTooStiff) {
  const StepReport right = step_with(1e7, 1, 0), stiff = step_with(1e7, 100, 0);
  EXPECT_TRUE(right.converged);
  EXPECT_TRUE(stiff.converged) << stiff.reason;
  EXPECT_LT(stiff.newton, 30);
}

// Iterations with a tangent made definite whose increments fall to so much of the one before, until the exact one is
// tried.
int until_exact(Exactness& exactness, double left, double& increment) {
  int count = 0;
  for (; exactness.next() != Definiteness::none && count < 1000; ++count)
    exactness.look(true, true, 1, increment *= left);
  return count;
}

TEST(Exactness, IsTriedWhereTheDefiniteTangentIsSlowAndKeptWhereItIsGood) {
  Exactness exactness(Definiteness::clamp, false);
  double increment = 1;
  EXPECT_EQ(until_exact(exactness, 0.1, increment), 1000);
  increment = 1;
  Exactness slow(Definiteness::clamp, false);
  EXPECT_EQ(until_exact(slow, 0.5, increment), 2);
  for (int k = 0; k < 5; ++k) {
    slow.look(true, true, 1, increment *= 0.1);
    EXPECT_EQ(slow.next(), Definiteness::none);
  }
}

// A cut step is good only where it falls further than the definite tangent's, and only where that one creeps.
TEST(Exactness, ACutStepIsGoodWhereTheOthersCreep) {
  for (const double left : {0.9, 0.5})
    for (const double fall : {2.0, 0.5}) {
      Exactness exactness(Definiteness::clamp, false);
      double increment = 1;
      until_exact(exactness, left, increment);
      exactness.look(true, false, fall, increment);
      EXPECT_EQ(exactness.next() == Definiteness::none, left == 0.9 && fall == 2) << left << " " << fall;
    }
}

// It waits ever longer for the next try, but not for ever.
TEST(Exactness, ComesBackHoweverOftenItWasInVain) {
  Exactness exactness(Definiteness::clamp, false);
  double increment = 1;
  int before = until_exact(exactness, 0.99, increment), count = before;
  for (int k = 0; k < 10; ++k) {
    exactness.look(false, true, 1, increment);
    count = until_exact(exactness, 0.99, increment);
    EXPECT_GE(count, before);
    EXPECT_LE(count, 64);
    before = count;
  }
  EXPECT_EQ(count, 64);
}

// Nearly incompressible and scrambled: what took a thousand iterations takes hundreds, and is solved.
TEST(Newton, AScrambledBodyThatIsNearlyIncompressibleOrStiffIsSolved) {
  for (const auto& [young, nu] : {std::pair{1e5, 0.4999}, {1e9, 0.45}})
    for (const std::uint64_t seed : {1, 2, 3}) {
      Scene scene = block("stable-neo-hookean", "backward-euler", "scrambled", seed);
      scene.bodies[0].materials[0].young = young;
      scene.bodies[0].materials[0].poisson = nu;
      Stepped run(scene);
      int most = 0;
      for (int k = 0; k < 40; ++k) {
        run.steps(1);
        most = std::max(most, run.last.newton);
      }
      EXPECT_LT(most, 400) << young << " " << nu << " " << seed;
    }
}

}  // namespace
}  // namespace sim::test
