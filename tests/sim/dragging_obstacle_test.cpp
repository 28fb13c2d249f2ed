// Obstacles that drag what touches them, by friction.
#include "tests/sim/obstacle_support.h"

namespace sim {
namespace {

// A block that is pressed down by 0.08 m and then moved by half a metre against the block below it: by pins at its top,
// or the block below moves the other way. The edge of that one comes under the bulge beside it.
Scene pressed_and_dragged(bool obstacle_moves) {
  Scene scene;
  scene.world.gravity = {0, 0, 0};
  scene.time.fps = 30;
  Body box = test::box_body("box", {0.8, 0.4, 0.5}, 4, {-0.4, 0.455, -0.25});
  box.damping.beta = 0.01;
  Pin top{InGroup{"top"}, "xyz", {}, {}};
  top.motion = {Keyframe{}, Keyframe{}, Keyframe{}};
  top.motion[1].t = 0.2;
  top.motion[1].translate = {0, -0.08, 0};
  top.motion[2].t = 1;
  top.motion[2].translate = {obstacle_moves ? 0 : -0.5, -0.08, 0};
  box.pins = {top};
  scene.bodies = {box};
  Obstacle below = test::surface_obstacle(test::box_mesh({0.8, 0.45, 1}, {-0.6, 0, -0.5}));
  below.friction = 1;
  if (obstacle_moves) {
    below.motion = {Keyframe{}, Keyframe{}, Keyframe{}};
    below.motion[1].t = 0.2;
    below.motion[2].t = 1;
    below.motion[2].translate = {0.5, 0, 0};
  }
  scene.obstacles = {below};
  return scene;
}

// It is the same to the block, and takes as many iterations: the obstacle does not drag what it has not reached.
TEST(DraggingObstacle, TakesAsManyIterationsAsPins) {
  double elastic[2];
  for (const bool obstacle_moves : {false, true}) {
    const Scene scene = pressed_and_dragged(obstacle_moves);
    test::Stepped run(scene);
    test::steps_without_crossing(scene, run, 30);
    std::printf("%s moves: %.1f iterations a step, at most %d\n", obstacle_moves ? "obstacle" : "pin",
                run.newton / 30.0, run.most_newton);
    EXPECT_LT(run.newton / 30.0, 50);
    EXPECT_LT(run.most_newton, 250);
    elastic[obstacle_moves] = run.system.measure(run.state).elastic;
  }
  EXPECT_NEAR(elastic[1], elastic[0], 0.1 * elastic[0]);
}

// A box on a table that turns by a quarter in 2 s stays where it is on the table, whatever the table is made of. A
// plane and a sphere have no node that this moves, and yet they drive the box.
TEST(DraggingObstacle, TurntablesCarryABox) {
  Obstacle plane, sphere, block = test::surface_obstacle(test::box_mesh({4, 1, 4}, {-2, -1, -2}));
  plane.shape = Plane{{0, 0, 0}, {0, 1, 0}};
  sphere.shape = Sphere{{0, -1000, 0}, 1000};
  for (Obstacle table : {plane, sphere, block}) {
    Scene scene;
    scene.time.fps = 30;
    scene.bodies = {test::box_body("box", {0.2, 0.2, 0.2}, 2, {0.5, 0.001, -0.1}, 1e6)};
    table.friction = 1;
    table.motion = {Keyframe{}, Keyframe{}};
    table.motion[1].t = 2;
    table.motion[1].axis = {0, 1, 0};
    table.motion[1].degrees = 90;
    scene.obstacles = {table};
    test::Stepped run(scene);
    run.steps(60);
    Vec3 middle = Vec3::Zero();
    const BodyRange& body = run.system.bodies()[0];
    for (int node = 0; node < body.node_count; ++node) middle += run.state.x.segment<3>(3 * node) / body.node_count;
    // It starts at rest on a table that turns at 0.79 rad/s: it slips v0^2/(2 mu g) = 1 cm until it is as fast.
    EXPECT_NEAR(middle.x(), 0, 0.03) << table.shape.index();
    EXPECT_NEAR(middle.z(), -0.6, 0.02) << table.shape.index();
    EXPECT_NEAR(middle.y(), 0.1, 0.005) << table.shape.index();
  }
}

}  // namespace
}  // namespace sim
