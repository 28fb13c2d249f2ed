// The drawn floor, and up.
#include "app/picture/floor.h"

#include <gtest/gtest.h>

#include "sim/mesh/generate.h"

namespace app {
namespace {

// A unit cube at rest on y = 0, held at its left side or not at all.
Document cube(bool held) {
  Document document;
  sim::Body body;
  body.name = "cube";
  body.mesh = sim::generate_box({1, 1, 1}, {1, 1, 1}, {1, 1, 1}, sim::ElementKind::tet4);
  body.materials = {sim::MaterialSpec{"stable-neo-hookean", 1e9, 0.3, 1000, ""}};
  if (held) body.pins = {sim::Pin{sim::InGroup{"left"}, "xyz", {}, {}}};
  document.scene.bodies = {body};
  return document;
}

struct Stage {
  explicit Stage(Document d)
      : document(std::move(d)),
        system(document.scene),
        stand(stand_of(document, system)),
        floor(system, document, stand) {}
  std::optional<double> height(const Vec3& moved = Vec3::Zero()) const {
    sim::State state = system.initial_state();
    for (Eigen::Index i = 0; i < state.x.size(); i += 3) state.x.segment<3>(i) += moved;
    const auto ground = floor.at(state);
    if (!ground) return std::nullopt;
    return (Vec3(ground->point[0], ground->point[1], ground->point[2]) + stand.origin).dot(stand.up);
  }
  Document document;
  sim::System system;
  Stand stand;
  Floor floor;
};

TEST(Floor, LiesBelowBodiesAndObstaclesAndGivesWay) {
  EXPECT_NEAR(*Stage(cube(true)).height(), -0.001, 1e-4);
  EXPECT_NEAR(*Stage(cube(true)).height({0, 2, 0}), -0.001, 1e-4);
  EXPECT_NEAR(*Stage(cube(true)).height({0, -3, 0}), -3.001, 1e-4);
  Document ball = cube(true);
  ball.scene.obstacles = {{sim::Sphere{{0, -2, 0}, 0.5}}};
  EXPECT_NEAR(*Stage(ball).height(), -2.501, 1e-4);
}

TEST(Floor, ASoftBodyIsExpectedToSag) {
  Document soft = cube(true);
  soft.scene.bodies[0].materials[0].young = 1e5;
  const double height = *Stage(soft).height();
  EXPECT_LT(height, -0.2);
  EXPECT_GT(height, -1.1);
}

TEST(Floor, ThereIsNoneWhereThePictureHasAPlaneAndUnderWhatFalls) {
  EXPECT_FALSE(Stage(cube(false)).height());
  Document weightless = cube(false);
  weightless.scene.world.gravity = {0, 0, 0};
  EXPECT_TRUE(Stage(weightless).height());
  Document floor = cube(true), wall = cube(true);
  floor.scene.obstacles = {{sim::Plane{{0, -2, 0}, {0, 1, 0}}}};
  wall.scene.obstacles = {{sim::Plane{{-2, 0, 0}, {1, 0, 0}}}};
  EXPECT_FALSE(Stage(floor).height());
  EXPECT_TRUE(Stage(wall).height());
  floor.look.ground_height = -3;
  EXPECT_NEAR(*Stage(floor).height({0, -9, 0}), -3, 1e-6);
  wall.look.ground = false;
  EXPECT_FALSE(Stage(wall).height());
}

TEST(Stand, UpIsAgainstGravityUnlessTheCameraSays) {
  Document document = cube(true);
  document.scene.world.gravity = {0, 0, -1.6};
  EXPECT_EQ(Stage(document).stand.up, Vec3(0, 0, 1));
  document.scene.world.gravity = {0, 0, 0};
  EXPECT_EQ(Stage(document).stand.up, Vec3(0, 1, 0));
  document.camera.up = Vec3(1, 0, 0);
  EXPECT_EQ(Stage(document).stand.up, Vec3(1, 0, 0));
}

TEST(Stand, PicturesOfFarScenesCountFromTheirMiddle) {
  EXPECT_EQ(Stage(cube(true)).stand.origin, Vec3(0, 0, 0));
  Document far = cube(true);
  far.scene.bodies[0].mesh.X.colwise() += Vec3(4e5, 4e6, 0);
  EXPECT_EQ(Stage(far).stand.origin, Vec3(400000.5, 4000000.5, 0.5));
  EXPECT_NEAR(*Stage(far).height(), 4e6 - 0.001, 0.01);
}

}  // namespace
}  // namespace app
