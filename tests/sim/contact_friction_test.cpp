// Friction between bodies: how far they slide, how slowly they creep, and that none is there where none is asked for.
#include "tests/sim/contact_support.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

constexpr double weight_per_mass = 9.81;

// A flat block on a slab that is held, pressed to it by gravity, which may have a part along x.
Scene block_on_slab(double friction, const Vec3& gravity) {
  Scene scene;
  scene.world.gravity = gravity;
  scene.bodies = {test::box_body("slab", {4, 0.2, 1}, 1, {-1, -0.2, -0.3}, 1e6),
                  test::box_body("block", {0.4, 0.1, 0.4}, 2, {0, 0, 0}, 1e6)};
  scene.bodies[0].pins = {Pin{Box{{-9, -9, -9}, {9, 9, 9}}, "xyz", {}, {}}};
  // The gap that carries it, to begin with: -b'(s) = p/kappa, p = 981 Pa, kappa = 1e5 Pa.
  translate(scene.bodies[1].mesh, {0, 0.943 * 0.4e-3, 0});
  scene.contacts = {Contact{}};
  scene.contacts[0].friction = friction;
  scene.solver.tolerance = 1e-7;
  return scene;
}

// Of the mean over the block's nodes: m, m/s.
struct Mean {
  Vec3 x = Vec3::Zero(), v = Vec3::Zero();
};
Mean mean_of(const test::Stepped& run, int body) {
  const BodyRange& range = run.system.bodies()[body];
  Mean mean;
  for (int i = range.first_node; i < range.first_node + range.node_count; ++i) {
    mean.x += run.state.x.segment<3>(3 * i) / range.node_count;
    mean.v += run.state.v.segment<3>(3 * i) / range.node_count;
  }
  return mean;
}

// A twentieth of a second on the slab, so that the gap carries it.
void settle(test::Stepped& run) {
  run.steps(run.system.steps_per_frame() * 30);
}

// Backward Euler's block loses mu g h in each step and moves with the speed at the step's end: v0^2/(2 mu g) - v0 h/2.
TEST(ContactFriction, SlidingBlockStopsWhereCoulombSays) {
  for (const int substeps : {1, 4}) {
    const double v0 = 2, mu = 0.5, h = 1.0 / 60 / substeps;
    Scene scene = block_on_slab(mu, {0, -weight_per_mass, 0});
    scene.time.substeps = substeps;
    test::Stepped run(scene);
    settle(run);
    const BodyRange& block = run.system.bodies()[1];
    for (int i = block.first_node; i < block.first_node + block.node_count; ++i) run.state.v[3 * i] += v0;
    const double start = mean_of(run, 1).x.x();
    run.steps(36 * substeps);
    const double way = mean_of(run, 1).x.x() - start, expected = v0 * v0 / (2 * mu * weight_per_mass) - v0 * h / 2;
    std::printf("h = %.4f s: slid %.4f m, expected %.4f m\n", h, way, expected);
    EXPECT_NEAR(way, expected, 0.01 * expected);
    EXPECT_EQ(test::count_crossings(scene, run.state.x), 0);
  }
}

// On a slope of tan = 0.5 it slides with a = g (sin - mu cos) just below mu = 0.5, and sticks just above it: at the
// speed eps (1 - sqrt(1 - tan/mu)), where friction has grown to what holds it.
TEST(ContactFriction, SlopeIsSlidDownOrCreptDown) {
  const double angle = std::atan(0.5);
  const Vec3 gravity = weight_per_mass * Vec3(std::sin(angle), -std::cos(angle), 0);
  test::Stepped slides(block_on_slab(0.49, gravity)), creeps(block_on_slab(0.51, gravity));
  settle(slides);
  const Mean start = mean_of(slides, 1);
  slides.steps(60);
  const double a = weight_per_mass * (std::sin(angle) - 0.49 * std::cos(angle));
  EXPECT_NEAR(mean_of(slides, 1).x.x() - start.x.x() - start.v.x(), a / 2 * (1 + 1.0 / 60), 0.02 * a / 2);

  settle(creeps);
  creeps.steps(60);
  const double eps = 1e-3 * 0.4;
  EXPECT_NEAR(mean_of(creeps, 1).v.x() / eps, 1 - std::sqrt(1 - 0.5 / 0.51), 0.02);
}

// A card without friction, turned on a flat surface of another mesh: barriers that counted a place twice would push it
// sideways.
TEST(ContactFriction, NoneNoSidewaysDrift) {
  Scene scene;
  scene.bodies = {test::box_body("table", {1, 0.1, 1}, 4, {0, -0.1, 0}, 1e6),
                  test::box_body("card", {0.5, 0.02, 0.3}, 3, {-0.25, 0, -0.15}, 1e6)};
  scene.bodies[0].pins = {Pin{InGroup{"bottom"}, "xyz", {}, {}}};
  rotate(scene.bodies[1].mesh, {0, 1, 0}, 17);
  translate(scene.bodies[1].mesh, {0.5, 4.9e-4, 0.5});
  scene.contacts = {Contact{}};
  test::Stepped run(scene);
  run.steps(60);
  const Vec3 v = mean_of(run, 1).v;
  const double sideways = std::hypot(v.x(), v.z());
  std::printf("sideways speed after 1 s: %.2e g\n", sideways / weight_per_mass);
  EXPECT_LT(sideways, 1e-2 * weight_per_mass);
  EXPECT_GT(mean_of(run, 1).x.y(), 0);
}

}  // namespace
}  // namespace sim
