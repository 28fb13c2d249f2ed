// Obstacles that are boxes and meshes, and obstacles that move: what scene files say of them, and what is drawn.
#include "app/picture/picture.h"
#include "app/scene/scene_identity.h"
#include "sim/stepper.h"
#include "tests/app/scene_fixture.h"

namespace app {
namespace {

using ObstacleScenes = SceneFile;

constexpr const char* plane_block = "[[body]]\nmesh = { rectangle = [1, 1], cells = [1, 1], translate = [0, 3] }\n";
constexpr const char* two_triangles = "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 1 3 2\nf 1 4 3\n";
constexpr const char* two_lines =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 3 1 3\n1 1 0 3\n1\n2\n3\n-2 1 0\n0 0 0\n2 1 0\n$EndNodes\n"
    "$Elements\n1 2 1 2\n1 1 1 2\n1 1 2\n2 2 3\n$EndElements\n";

const sim::RigidSurface& surface(const Document& document, std::size_t k = 0) {
  return std::get<sim::RigidSurface>(document.scene.obstacles.at(k).shape);
}

TEST_F(ObstacleScenes, ABoxIsTwelveTriangles) {
  const Document document = load(body("[[obstacle]]\nbox = [[-1, -3, -1], [2, -2, 2]]\nfriction = 0.3\n"));
  EXPECT_EQ(surface(document).X.cols(), 8);
  EXPECT_EQ(surface(document).faces.cols(), 12);
  EXPECT_EQ(surface(document).X.rowwise().minCoeff(), Vec3(-1, -3, -1));
  EXPECT_EQ(surface(document).X.rowwise().maxCoeff(), Vec3(2, -2, 2));
  EXPECT_EQ(document.scene.obstacles[0].friction, 0.3);
  EXPECT_EQ(document.scene.obstacles[0].name, "obstacle0");
}

TEST_F(ObstacleScenes, ABoxInThePlaneIsFourLines) {
  const Document document = load(std::string(plane_block) + "[[obstacle]]\nbox = [[-1, -3], [2, -2]]\n");
  EXPECT_EQ(surface(document).X.rows(), 2);
  EXPECT_EQ(surface(document).faces.cols(), 4);
  EXPECT_EQ(document.obstacle_meshes[0].triangles.cols(), 2);
}

TEST_F(ObstacleScenes, ASurfaceFileIsPlacedAsBodiesAre) {
  file("table.obj", two_triangles);
  const Document document =
      load(body("[[obstacle]]\nmesh = { file = \"table.obj\", scale = 2, translate = [0, -1, 0] }\n"));
  EXPECT_EQ(surface(document).X.rowwise().maxCoeff(), Vec3(2, -1, 2));
  EXPECT_EQ(surface(document).faces.cols(), 2);
}

TEST_F(ObstacleScenes, OnlyTheSurfaceOfASolidCounts) {
  const Document document =
      load(body("[[obstacle]]\nmesh = { box = [1, 1, 1], cells = [3, 3, 3], translate = [0, -2, 0] }\n"));
  EXPECT_EQ(surface(document).X.cols(), 64 - 8);
  EXPECT_EQ(surface(document).faces.cols(), 6 * 9 * 2);
}

TEST_F(ObstacleScenes, LinesOfAFileStandInAPlaneScene) {
  file("valley.msh", two_lines);
  const std::string obstacle = "[[obstacle]]\nmesh = { file = \"valley.msh\", translate = [0, -1] }\n";
  const Document document = load(plane_block + obstacle);
  EXPECT_EQ(surface(document).X.col(1), Eigen::Vector2d(0, -1));
  EXPECT_EQ(surface(document).faces.cols(), 2);
  EXPECT_NE(error(body("[[obstacle]]\nmesh = { file = \"valley.msh\" }\n"))
                .find("obstacle.0.mesh.file = \"valley.msh\": is made of lines, which are for 2D scenes"),
            std::string::npos);
}

TEST_F(ObstacleScenes, MotionAndReleaseAreRead) {
  const Document document =
      load(body("[[obstacle]]\nname = \"press\"\nsphere = [[0, 5, 0], 1]\nrelease = 2\n"
                "motion = { keyframes = [[0, {}], [1, { translate = [0, -1, 0], rotate = { degrees = 30 } }]] }\n"));
  const sim::Obstacle& press = document.scene.obstacles[0];
  EXPECT_EQ(press.name, "press");
  EXPECT_EQ(press.release, 2);
  ASSERT_EQ(press.motion.size(), 2U);
  EXPECT_EQ(press.motion[1].translate, Vec3(0, -1, 0));
  EXPECT_EQ(press.motion[1].degrees, 30);
}

TEST_F(ObstacleScenes, MistakesAreNamed) {
  const std::pair<std::string, std::string> cases[] = {
      {"[[obstacle]]\nbox = [[0, 0, 0], [1, 1, 1]]\nsphere = [[0, 0, 0], 1]\n",
       "obstacle.0: must have exactly one of plane, sphere, box, mesh"},
      {"[[obstacle]]\nbox = [[0, -3, 0], [1, -3, 1]]\n", "obstacle.0.box"},
      {"[[obstacle]]\nmesh = { scale = 2 }\n", "obstacle.0.mesh: must have exactly one of box, rectangle, sheet, file"},
      {"[[obstacle]]\nmesh = { file = \"none.obj\" }\n", "obstacle.0.mesh.file = \"none.obj\""},
      {"[[obstacle]]\nmesh = { box = [1, 1, 1] }\n", "obstacle.0.mesh: 'cells' is missing"},
      {"[[obstacle]]\nplane = { point = [0, -9, 0], normal = [0, 1, 0] }\n"
       "motion = { keyframes = [[1, {}], [1, {}]] }\n",
       "obstacle.0.motion.keyframes.1.0 = 1: must be later than the pose before it"},
      {"[[obstacle]]\nname = \"a\"\nsphere = [[0, -9, 0], 1]\n[[obstacle]]\nname = \"a\"\nsphere = [[0, -9, 0], 1]\n",
       "obstacle.1.name = \"a\": is the name of another one already"}};
  for (const auto& [text, message] : cases)
    EXPECT_NE(error(body(text)).find(message), std::string::npos) << error(body(text));
}

// A mesh file may change while its name stays.
TEST_F(ObstacleScenes, WhatAFileHoldsBelongsToTheScene) {
  file("table.obj", two_triangles);
  const std::string text = body("[[obstacle]]\nmesh = { file = \"table.obj\", translate = [0, -1, 0] }\n");
  const std::uint64_t before = scene_identity(load(text));
  EXPECT_EQ(scene_identity(load(text)), before);
  file("table.obj", "v -1 0 -2\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 1 3 2\nf 1 4 3\n");
  EXPECT_NE(scene_identity(load(text)), before);
}

// Drawn where it is at the moment of the frame, behind the bodies, and no longer after its release.
TEST_F(ObstacleScenes, SurfacesAreDrawnWhereTheyAre) {
  const Document document = load(body(
      "[[obstacle]]\nbox = [[-1, -3, -1], [2, -2, 2]]\nrelease = 0.5\n"
      "motion = { keyframes = [[0, {}], [1, { translate = [0, -1, 0] }]] }\n"
      "[[obstacle]]\nsphere = [[0, -9, 0], 1]\nmotion = { keyframes = [[0, {}], [1, { translate = [0, -1, 0] }]] }\n"));
  const sim::System system(document.scene);
  const Picture picture(system, document, 320, 180);
  Moment moment;
  moment.state = system.initial_state();
  const auto stepper = sim::make_stepper(system, 1);
  for (int k = 0; k < 30; ++k) stepper->step(moment.state);
  const render::Frame frame = picture.frame(moment);
  ASSERT_EQ(frame.surfaces.size(), 2U);
  EXPECT_EQ(frame.surfaces[1].name, "obstacle0");
  float lowest = 0;
  for (std::size_t i = 1; i < frame.surfaces[1].positions.size(); i += 3)
    lowest = std::min(lowest, frame.surfaces[1].positions[i]);
  EXPECT_NEAR(lowest, -3.5, 1e-5);
  ASSERT_EQ(frame.spheres.size(), 1U);
  EXPECT_NEAR(frame.spheres[0].centre[1], -9.5, 1e-5);
  EXPECT_TRUE(frame.labels.empty());  // there is one body only
  stepper->step(moment.state);
  EXPECT_EQ(picture.frame(moment).surfaces.size(), 1U);
}

}  // namespace
}  // namespace app
