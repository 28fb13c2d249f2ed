// What a flight of many steps is said to have changed, against the closed forms of a stone's throw.
#include "sim/study/flight_drift.h"

#include "tests/sim/stepping.h"

namespace sim::test {
namespace {

constexpr double mass_thrown = 2 * 1e3;  // kg

Scene thrown(const Vec3& velocity, const Vec3& gravity) {
  Scene scene;
  Body body;
  body.name = "block";
  body.mesh = generate_box({2, 1, 1}, {2, 1, 1}, {1, 1, 1}, ElementKind::tet4);
  body.materials = {MaterialSpec{"stable-neo-hookean", 1e5, 0.3, 1000, ""}};
  body.velocity = velocity;
  scene.world.gravity = gravity;
  scene.solver.tolerance = 1e-12;
  scene.bodies = {body};
  return scene;
}

FlightDrift drift_of(const System& system) {
  return flight_drift(system, 30, [] { return false; });
}

// v = v_0 + g t. By backward Euler the centre is at c_k = c_0 + v_0 t_k + g h^2 k(k+1)/2 after k steps, and one more
// adds h c_k x m g to L = m c x v.
TEST(FlightDrift, OfAThrownBodyIsWhatTheFallMakesOfIt) {
  const Vec3 v(3, 4, 0), g(0, 0, -1.5), c(1, 0.5, 0.5);
  constexpr int steps = 30;
  constexpr double longest_side = 2;
  const System system(thrown(v, g));
  const double h = system.step_seconds(), t = steps * h;
  const FlightDrift d = drift_of(system);
  EXPECT_EQ(d.failure, "");
  EXPECT_EQ(d.steps, steps);
  EXPECT_NEAR(d.p, 1.5 * t / 5, 1e-9);
  EXPECT_NEAR(d.energy, (1.5 * t / 5) * (1.5 * t / 5), 1e-9);
  Vec3 dL = Vec3::Zero();
  for (int k = 0; k < steps; ++k) dL += h * mass_thrown * (c + k * h * v + h * h * k * (k + 1) / 2 * g).cross(g);
  EXPECT_NEAR(d.L, dL.norm() / (mass_thrown * c.cross(v).norm()), 1e-9);
  EXPECT_NEAR(d.away, 4 * t / longest_side, 1e-9);
}

// Where there is nothing to relate to, the changes themselves: of a body that is let go at rest.
TEST(FlightDrift, OfABodyAtRestIsNotRelative) {
  const FlightDrift rest = drift_of(System(thrown({0, 0, 0}, {0, 0, 0})));
  EXPECT_EQ(rest.steps, 30);
  for (const double change : {rest.p / mass_thrown, rest.L / mass_thrown, rest.energy, rest.away})
    EXPECT_NEAR(change, 0, 1e-12);
  const System system(thrown({0, 0, 0}, {0, 0, -1.5}));
  const FlightDrift dropped = drift_of(system);
  const double t = 30 * system.step_seconds();
  EXPECT_NEAR(dropped.p, mass_thrown * 1.5 * t, 1e-6);
  EXPECT_NEAR(dropped.energy, mass_thrown * 1.5 * t * 1.5 * t / 2, 1e-6);
}

// A turning body loses energy by backward Euler: the sign is that of the change.
TEST(FlightDrift, IsNegativeWhereEnergyIsLost) {
  Scene scene = thrown({0, 0, 0}, {0, 0, 0});
  scene.bodies[0].spin = {{0, 0, 1}, 2};
  const FlightDrift d = drift_of(System(scene));
  EXPECT_LT(d.energy, -0.01);
  EXPECT_GT(d.energy, -1);
}

TEST(FlightDrift, SaysAfterHowManyStepsItEndedAndWhy) {
  int asked = 0;
  const FlightDrift interrupted = flight_drift(System(thrown({1, 0, 0}, {0, 0, 0})), 30, [&] { return ++asked > 7; });
  EXPECT_EQ(interrupted.steps, 7);
  EXPECT_EQ(interrupted.failure, "");
  // Far beyond the stable step of an explicit scheme.
  Scene scene = thrown({0, 0, 0}, {0, 0, 0});
  scene.time.integrator = "central-difference";
  scene.time.fps = 1;
  scene.bodies[0].spin = {{0, 0, 1}, 2};
  const FlightDrift failed = flight_drift(System(scene), 1000, [] { return false; });
  EXPECT_NE(failed.failure, "");
  EXPECT_GT(failed.steps, 0);
  EXPECT_LT(failed.steps, 1000);
  EXPECT_GT(failed.energy, 1);
}

}  // namespace
}  // namespace sim::test
