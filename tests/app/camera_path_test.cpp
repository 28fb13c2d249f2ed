#include "app/picture/camera_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/view.h"
#include "sim/mesh/generate.h"

namespace app {
namespace {

// Two unit boxes, 2 m apart, 1 step a frame at 10 frames a second.
Document two_boxes() {
  Document document;
  document.scene.time.fps = 10;
  for (int i = 0; i < 2; ++i) {
    sim::Body body;
    body.name = i == 0 ? "left" : "right";
    body.mesh = sim::generate_box({1, 1, 1}, {1, 1, 1}, {1, 1, 1}, sim::ElementKind::tet4);
    body.mesh.X.row(0).array() += 3 * i;
    body.materials = {sim::MaterialSpec{}};
    document.scene.bodies.push_back(body);
  }
  return document;
}

Vec3 vec(const render::Point& p) {
  return {p[0], p[1], p[2]};
}

struct Stage {
  explicit Stage(Document d) : document(std::move(d)), system(document.scene), shot(system, document, 1.5) {}
  sim::State at(std::int64_t step) const {
    sim::State state = system.initial_state();
    state.step = step;
    return state;
  }
  Document document;
  sim::System system;
  CameraPath shot;
};

// The largest distance of a node from the middle of the picture, 1 at its edge.
double farthest(const Stage& stage, const sim::State& state) {
  const render::View view = render::make_view(stage.shot.at(state), 1.5F, {});
  double most = 0;
  for (Eigen::Index i = 0; i < state.x.size(); i += 3) {
    const Eigen::Vector3f at = view.to_window(state.x.segment<3>(i).cast<float>(), 2, 2);
    if (at.z() <= 0) return 1e9;
    most = std::max({most, std::abs(double(at.x()) - 1), std::abs(double(at.y()) - 1)});
  }
  return most;
}

TEST(CameraPath, WithoutACameraEverythingIsSeenWhereverItGoes) {
  const Stage stage(two_boxes());
  sim::State state = stage.at(0);
  EXPECT_LT(farthest(stage, state), 0.9);
  EXPECT_GT(farthest(stage, state), 0.5);
  for (const Vec3& way : {Vec3(0.05, 0, 0), Vec3(9, 0, 0), Vec3(0, -30, 0), Vec3(0, 0, 8)}) {
    sim::State moved = state;
    for (Eigen::Index i = 0; i < moved.x.size() / 2; i += 3) moved.x.segment<3>(i) += way;
    EXPECT_LT(farthest(stage, moved), 1) << way.transpose();
  }
}

TEST(CameraPath, ABodyThatSwingsALittleDoesNotMoveTheCamera) {
  const Stage stage(two_boxes());
  sim::State moved = stage.at(0);
  for (double& x : moved.x) x *= 1.02;
  EXPECT_EQ(stage.shot.at(moved).eye, stage.shot.at(stage.at(0)).eye);
}

TEST(CameraPath, WhereABodyWillFallIsSeenFromTheStart) {
  Document document = two_boxes();
  document.scene.obstacles = {{sim::Plane{{0, -6, 0}, {0, 1, 0}}}};
  const Stage stage(document);
  sim::State fallen = stage.at(0);
  for (Eigen::Index i = 1; i < fallen.x.size(); i += 3) fallen.x[i] -= 6;
  EXPECT_EQ(stage.shot.at(fallen).eye, stage.shot.at(stage.at(0)).eye);
  EXPECT_LT(farthest(stage, fallen), 0.95);
}

TEST(CameraPath, AnOrbitTurnsAboutUpAndKeepsItsDistance) {
  Document document = two_boxes();
  document.camera.eye = Vec3(2, 1, 10);
  document.camera.target = Vec3(2, 0, 0);
  document.camera.orbit = 90;
  const Stage stage(document);
  const render::Camera turned = stage.shot.at(stage.at(10));  // 1 s: z turns to x
  EXPECT_NEAR((vec(turned.eye) - Vec3(12, 1, 0)).norm(), 0, 1e-5);
  EXPECT_NEAR((vec(turned.target) - Vec3(2, 0, 0)).norm(), 0, 1e-6);
}

TEST(CameraPath, AScriptIsEasedAndHoldsItsEnds) {
  Document document = two_boxes();
  document.camera.eye = Vec3(0, 0, 10);
  document.camera.target = Vec3(0, 0, 0);
  document.camera.keyframes = {{1, 0, 0, 1}, {3, 60, 30, 4}};
  const Stage stage(document);
  const auto turn = [&](std::int64_t step) {
    const Vec3 eye = vec(stage.shot.at(stage.at(step)).eye);
    return std::atan2(eye.x(), eye.z()) * 180 / std::numbers::pi;
  };
  EXPECT_NEAR(turn(0), 0, 1e-5);
  EXPECT_NEAR(turn(10), 0, 1e-5);
  EXPECT_NEAR(turn(15), 60 * 0.15625, 1e-4);  // s = 1/4: s^2 (3 - 2 s)
  EXPECT_NEAR(turn(20), 30, 1e-4);
  EXPECT_NEAR(turn(30), 60, 1e-4);
  EXPECT_NEAR(turn(99), 60, 1e-4);
  const render::Camera end = stage.shot.at(stage.at(30));
  EXPECT_NEAR(std::asin(vec(end.eye).y() / 10) * 180 / std::numbers::pi, 30, 1e-4);
  EXPECT_NEAR(vec(end.eye).norm(), 10, 1e-5);
  // Four times as large: a quarter of the height is seen.
  EXPECT_NEAR(std::tan(end.field_of_view / 2 * std::numbers::pi / 180), std::tan(15 * std::numbers::pi / 180) / 4,
              1e-6);
  document.camera.keyframes = {{0, 0, 500, 1}};
  const Stage steep(document);
  EXPECT_GT(vec(steep.shot.at(steep.at(0)).eye).z(), 0.1);  // short of straight above
}

TEST(CameraPath, ACameraThatFollowsKeepsItsPlaceBesideTheBody) {
  Document document = two_boxes();
  document.camera.follow = "right";
  const Stage stage(document);
  const render::Camera before = stage.shot.at(stage.at(0));
  sim::State moved = stage.at(5);
  for (Eigen::Index i = moved.x.size() / 2; i < moved.x.size(); i += 3) moved.x.segment<3>(i) += Vec3(7, -2, 1);
  const render::Camera after = stage.shot.at(moved);
  EXPECT_NEAR((vec(after.eye) - vec(before.eye) - Vec3(7, -2, 1)).norm(), 0, 1e-5);
  EXPECT_NEAR((vec(after.target) - vec(before.target) - Vec3(7, -2, 1)).norm(), 0, 1e-5);
}

}  // namespace
}  // namespace app
