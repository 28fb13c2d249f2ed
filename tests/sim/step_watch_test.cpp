// The step of explicit schemes: its limit with damping, and as a body deforms.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/build/parts.h"
#include "sim/time/stable_step.h"
#include "tests/sim/allocations.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

// A cube that is pressed together to less than a third and let out again.
Scene pressed_cube(const char* integrator, double beta) {
  Scene scene;
  Body body;
  body.name = "cube";
  body.mesh = generate_box({1, 1, 1}, {4, 4, 4}, {1, 1, 1}, ElementKind::tet4);
  body.materials = {MaterialSpec{"stable-neo-hookean", 1e5, 0.4, 1000, ""}};
  body.damping.beta = beta;
  Pin moving{InGroup{"right"}, "xyz", {}, {}};
  moving.motion = {{0, {0, 0, 0}}, {0.2, {-0.7, 0, 0}}, {0.4, {0, 0, 0}}};
  body.pins = {Pin{InGroup{"left"}, "xyz", {}, {}}, moving};
  scene.bodies = {body};
  scene.world.gravity.setZero();
  scene.time.integrator = integrator;
  scene.time.fps = 30;
  scene.time.substeps = 0;
  return scene;
}

// v' = v - h (omega^2 x + d v), x' = x + h v' from x = 1: the largest |x| of many steps.
double reach(double omega2, double d, double h) {
  double x = 1, v = 0, most = 0;
  for (int k = 0; k < 2000 && most < 1e9; ++k) {
    v -= h * (omega2 * x + d * v);
    x += h * v;
    most = std::max(most, std::abs(x));
  }
  return most;
}

TEST(StableStep, IsThatOfADampedVibration) {
  EXPECT_DOUBLE_EQ(stable_step(100, 0), 0.2);
  for (const auto& [omega2, d] :
       {std::pair(100.0, 0.0), std::pair(100.0, 3.0), std::pair(1e4, 500.0), std::pair(0.0, 8.0)}) {
    const double h = stable_step(omega2, d);
    EXPECT_LT(reach(omega2, d, 0.99 * h), 20) << omega2 << ' ' << d;
    EXPECT_GT(reach(omega2, d, 1.01 * h), 1e9 * (omega2 > 0)) << omega2 << ' ' << d;
  }
  EXPECT_TRUE(std::isinf(stable_step(0, 0)));
}

TEST(StableStep, IsShorterWithDamping) {
  Scene scene = test::beam("tet4", 1);
  scene.time.integrator = "central-difference";
  scene.time.substeps = 0;
  const double undamped = System(scene).stable_step(), omega2 = 4 / (lacking * undamped * undamped);
  for (const double beta : {1e-4, 1e-2}) {
    scene.bodies[0].damping = {0.1, beta};
    const double expected = stable_step(lacking * omega2, lacking * (0.1 + beta * omega2));
    EXPECT_NEAR(System(scene).stable_step(), expected, 1e-3 * expected) << beta;
    test::Stepped run(scene);
    run.steps(10 * run.system.steps_per_frame());
    EXPECT_GT(run.last.min_J, 0.5) << beta;
  }
}

TEST(StepWatch, StepsArePartedWhereTheBodyStiffens) {
  for (const char* integrator : {"symplectic-euler", "central-difference"}) {
    Scene scene = pressed_cube(integrator, 0);
    test::Stepped run(scene);
    EXPECT_GE(run.most_parts(15), 2) << integrator;
    EXPECT_EQ(run.state.parts, 1) << integrator << ": at rest again";
    EXPECT_GT(run.last.min_J, 0.3) << integrator;
    // The same steps do not hold where they are not watched.
    scene.time.substeps = run.system.steps_per_frame();
    test::Stepped unwatched(scene);
    bool whole = true;
    for (int k = 0; k < 15 * run.system.steps_per_frame() && whole; ++k) {
      unwatched.last = unwatched.stepper->step(unwatched.state);
      whole = unwatched.last.failure.empty() && unwatched.last.min_J > 0;
    }
    EXPECT_FALSE(whole) << integrator;
  }
}

TEST(StepWatch, ResumesToTheSameBits) {
  for (const int threads : {1, 2})
    for (const int saved_at : {5, 16, 37}) {
      const Scene scene = pressed_cube("central-difference", 1e-4);
      test::Stepped straight(scene), resumed(scene, threads);
      straight.steps(saved_at);
      resumed.state = straight.state;
      straight.steps(60);
      resumed.steps(60);
      EXPECT_EQ(hash(straight.state), hash(resumed.state)) << saved_at << ' ' << threads;
    }
}

TEST(StepWatch, LooksAllocateNothing) {
  if (!test::can_count_allocations()) GTEST_SKIP();
  test::Stepped run(pressed_cube("symplectic-euler", 1e-4));
  run.steps(15);
  test::start_counting();
  for (int k = 0; k < 3; ++k) run.stepper->step(run.state);  // one of them looks
  EXPECT_EQ(test::stop_counting(), 0);
}

}  // namespace
}  // namespace sim
