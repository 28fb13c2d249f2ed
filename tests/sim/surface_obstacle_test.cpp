// Obstacles that are surfaces: they carry bodies, on both of their sides, and nothing starts in them.
#include "tests/sim/obstacle_support.h"

namespace sim {
namespace {

using test::lowest, test::one_box, test::steps_without_crossing;

TEST(SurfaceObstacle, CarriesTheWeightOfABody) {
  Scene scene = one_box();
  scene.obstacles = {test::surface_obstacle(test::box_mesh({4, 1, 4}, {-1.3, -1, -1.4}))};
  scene.bodies[0].damping.alpha = 5;
  test::Stepped run(scene);
  steps_without_crossing(scene, run, 120);
  const ContactReport report = run.system.contacts(run.state).at(0);
  EXPECT_NEAR(report.force.y(), 9810, 100);
  EXPECT_GT(report.gap, 0);
  EXPECT_LT(report.gap, 1e-3);
}

// An open surface, a sheet of two triangles, holds from above and from below.
TEST(SurfaceObstacle, HoldsFromBothSides) {
  for (const double side : {1.0, -1.0}) {
    Scene scene = one_box();
    scene.world.gravity = {0, -9.81 * side, 0};
    RigidSurface sheet{Eigen::MatrixXd(3, 4), Eigen::MatrixXi(3, 2)};
    const double y = side > 0 ? 0 : 1.02;
    sheet.X << -1, 3, 3, -1, y, y, y, y, -2, -2, 2, 2;
    sheet.faces << 0, 0, 1, 2, 2, 3;
    Obstacle obstacle;
    obstacle.shape = sheet;
    scene.obstacles = {obstacle};
    test::Stepped run(scene);
    steps_without_crossing(scene, run, 60);
    EXPECT_EQ(run.system.contacts(run.state).at(0).pairs > 0, true);
  }
}

TEST(SurfaceObstacle, OfLinesInThePlane) {
  Scene scene;
  scene.dimension = 2;
  Body body;
  body.name = "block";
  body.mesh = generate_rectangle({1, 1}, {3, 3}, {1, 1}, ElementKind::tri3);
  translate(body.mesh, {0, 0.5, 0});
  body.materials = {MaterialSpec{"stable-neo-hookean", 1e5, 0.3, 1000, ""}};
  body.damping.alpha = 5;
  scene.bodies = {body};
  RigidSurface valley{Eigen::MatrixXd(2, 3), Eigen::MatrixXi(2, 2)};
  valley.X << -2, 0.5, 3, 2, -0.2, 2;
  valley.faces << 0, 1, 1, 2;
  Obstacle obstacle;
  obstacle.shape = valley;
  scene.obstacles = {obstacle};
  test::Stepped run(scene);
  steps_without_crossing(scene, run, 150);
  EXPECT_GT(lowest(run.state, run.system.bodies()[0], 2), -0.2);
  EXPECT_NEAR(run.system.contacts(run.state).at(0).force.y(), 9810, 1000);
}

TEST(SurfaceObstacle, BodiesThatStartInItAreRefused) {
  Scene scene = one_box();
  scene.obstacles = {test::surface_obstacle(test::box_mesh({4, 1, 4}, {-1.3, -0.9, -1.4}))};
  try {
    System system(scene);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.key, "obstacle.0");
    EXPECT_NE(std::string(error.what()).find("\"box\""), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace sim
