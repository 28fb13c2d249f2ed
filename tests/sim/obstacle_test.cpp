// Obstacles: how much their barriers carry, and that nothing jumps through them.
#include <gtest/gtest.h>

#include "tests/sim/contact_support.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

Scene box_on_floor(int cells, double friction) {
  Scene scene;
  scene.bodies = {test::box_body("box", {1, 1, 1}, cells, {0, 0.7e-3, 0}, 1e6)};
  Obstacle floor;
  floor.shape = Plane{{0, 0, 0}, {0, 1, 0}};
  floor.friction = friction;
  scene.obstacles = {floor};
  return scene;
}

// As between bodies: the gap at a pressure p is that of -b'(s) = p/kappa with kappa = E/10, at any mesh. That is 0.83
// of dh = 1 mm for the weight of a metre. Nodes at the box's edges have a part of its sides as well, and a wider gap.
TEST(Obstacle, GapCarriesTheWeightAtAnyMesh) {
  for (const int cells : {2, 4, 6}) {
    Scene scene = box_on_floor(cells, 0);
    scene.time.integrator = "static";
    scene.solver.tolerance = 1e-7;
    scene.bodies[0].materials = {MaterialSpec{"linear", 1e6, 0, 1000, ""}};
    scene.bodies[0].pins = {Pin{Box{{-9, -9, -9}, {9, 9, 9}}, "xz", {}, {}}};
    test::Stepped run(scene);
    run.steps(1);
    double least = 1;
    for (Eigen::Index i = 1; i < run.state.x.size(); i += 3) least = std::min(least, run.state.x[i]);
    std::printf("%d cells: %.3f of dh\n", cells, least / 1e-3);
    EXPECT_NEAR(least / 1e-3, 0.83, 0.05) << cells;
  }
}

// A soft box tumbles on a rough floor: gaps that sank to a small part of the barrier took a sixth more iterations.
TEST(Obstacle, TumblingTakesFewIterations) {
  Scene scene = box_on_floor(1, 0.5);
  scene.bodies[0] = test::box_body("box", {0.4, 0.4, 0.4}, 4, {0, 0, 0}, 3e4);
  rotate(scene.bodies[0].mesh, {1, 0, 1}, 30);
  translate(scene.bodies[0].mesh, {0, 0.6, 0});
  scene.bodies[0].velocity = {2, 0, 0};
  test::Stepped run(scene);
  int all = 0;
  for (int k = 0; k < 60; ++k) {
    run.steps(1);
    all += run.last.newton;
  }
  std::printf("%d iterations in 60 steps\n", all);
  EXPECT_LT(all, 500);
}

// The start of an iteration is limited as well: a fast box does not jump through a ball obstacle.
TEST(Obstacle, IsNotPassedBetweenSteps) {
  Scene scene;
  scene.world.gravity = {0, 0, 0};
  scene.bodies = {test::box_body("box", {1, 1, 1}, 2, {-0.5, 0.3, -0.5}, 1e6)};
  scene.bodies[0].velocity = {0, -40, 0};
  Obstacle ball;
  ball.shape = Sphere{{0, 0, 0}, 0.12};
  scene.obstacles = {ball};
  System system(scene);
  State state = system.initial_state();
  const auto stepper = make_stepper(system, 1);
  // In one step it would be 0.67 m lower: the node above the ball stays on it.
  ASSERT_EQ(stepper->step(state).failure, "");
  double lowest = 1e9;
  for (Eigen::Index i = 0; i < state.x.size(); i += 3)
    if (std::abs(state.x[i]) < 0.1 && std::abs(state.x[i + 2]) < 0.1) lowest = std::min(lowest, state.x[i + 1]);
  EXPECT_GT(lowest, 0.05);
}

}  // namespace
}  // namespace sim
