#include "render/view.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "render/light.h"
#include "render/rect.h"

namespace {

using Eigen::Vector3f;
using render::Camera;

constexpr float aspect = 16.0F / 9;

render::Bounds unit_bounds() {
  render::Bounds bounds;
  bounds.add({-1, -1, -1});
  bounds.add({1, 1, 1});
  return bounds;
}

TEST(View, TargetIsTheMiddleAndUpIsUp) {
  Camera camera;
  camera.eye = {3, 2, 5};
  camera.target = {0.5F, 0.25F, -1};
  const render::View view = render::make_view(camera, aspect, unit_bounds());
  const Vector3f middle = view.to_window(view.target, 1280, 720);
  EXPECT_NEAR(middle.x(), 640, 1e-2);
  EXPECT_NEAR(middle.y(), 360, 1e-2);
  EXPECT_NEAR(middle.z(), (view.target - view.eye).norm(), 1e-5);
  EXPECT_LT(view.to_window(view.target + Vector3f(0, 0.1F, 0), 1280, 720).y(), 360);
  EXPECT_GT(view.to_window(view.target + 0.1F * view.right, 1280, 720).x(), 640);
}

TEST(View, FieldOfViewFillsTheHeight) {
  Camera camera;  // at (0, 0, 5), looking down -z
  camera.field_of_view = 40;
  const render::View view = render::make_view(camera, aspect, unit_bounds());
  const auto top = static_cast<float>(5 * std::tan(20 * M_PI / 180));
  EXPECT_NEAR(view.to_window({0, top, 0}, 1280, 720).y(), 0, 1e-2);
  EXPECT_NEAR(view.to_window({-top * aspect, 0, 0}, 1280, 720).x(), 0, 1e-2);
  EXPECT_NEAR(view.extent, 2 * top, 1e-5);
}

TEST(View, ParallelCameraShowsItsHeightAtEveryDepth) {
  Camera camera;
  camera.orthographic = true;
  camera.height = 3;
  const render::View view = render::make_view(camera, aspect, unit_bounds());
  for (const float z : {-1.0F, 0.0F, 1.0F}) {
    EXPECT_NEAR(view.to_window({0, 1.5F, z}, 1280, 720).y(), 0, 1e-3);
    EXPECT_NEAR(view.to_window({1.5F * aspect, 0, z}, 1280, 720).x(), 1280, 1e-3);
  }
}

TEST(View, EverythingLiesBetweenTheClipPlanes) {
  render::Bounds far_away = unit_bounds();
  far_away.add({0, 0, -1000});
  const render::View view = render::make_view(Camera{}, aspect, far_away);
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector4f clip = view.world_to_clip * far_away.corner(k).homogeneous();
    EXPECT_LE(std::abs(clip.z()), clip.w()) << "corner " << k;
  }
}

TEST(View, CamerasWithoutDirectionAreRefused) {
  const auto refuses = [](auto change) {
    Camera camera;
    change(camera);
    EXPECT_THROW(render::make_view(camera, aspect, unit_bounds()), std::invalid_argument);
  };
  refuses([](Camera& c) { c.target = c.eye; });
  refuses([](Camera& c) { c.up = {0, 0, 1}; });
  refuses([](Camera& c) { c.eye[1] = std::numeric_limits<float>::quiet_NaN(); });
  refuses([](Camera& c) { c.field_of_view = 180; });
  refuses([](Camera& c) {
    c.orthographic = true;
    c.height = 0;
  });
}

TEST(Rect, HoldsThePointsAndStaysInThePicture) {
  const render::View view = render::make_view(Camera{}, aspect, unit_bounds());
  Eigen::Matrix3Xf points(3, 2);
  points << -0.5F, 0.25F, 0, 0.5F, 0, 0;
  const render::Rect rect = render::rect_of(points, view, 1280, 720, 0);
  const Vector3f low = view.to_window(points.col(0), 1280, 720), high = view.to_window(points.col(1), 1280, 720);
  EXPECT_EQ(rect.x, static_cast<int>(std::floor(low.x())));
  EXPECT_EQ(rect.x + rect.width, static_cast<int>(std::ceil(high.x())));
  EXPECT_NEAR(rect.y, 720 - low.y(), 1);
  EXPECT_NEAR(rect.y + rect.height, 720 - high.y(), 1);

  points.col(1) << 0, 0, 6;  // behind the eye
  const render::Rect all = render::rect_of(points, view, 1280, 720, 0);
  EXPECT_EQ(all.width, 1280);
  EXPECT_EQ(all.height, 720);

  points << 50, 60, 0, 1, 0, 0;  // beside the picture
  EXPECT_TRUE(render::rect_of(points, view, 1280, 720, 4).empty());
  EXPECT_TRUE(render::rect_of(points.leftCols(0), view, 1280, 720, 4).empty());
}

TEST(Light, ShadowMapHoldsTheCasters) {
  render::Frame frame;
  frame.camera.eye = {4, 3, 5};
  const render::View view = render::make_view(frame.camera, aspect, unit_bounds());
  const render::Light light = render::light_of(frame, view);
  EXPECT_GT(light.key.y(), 0.5F);                 // from above
  EXPECT_GT(light.key.dot(-view.forward), 0.3F);  // from the viewer's side
  const Eigen::Matrix4f matrix = render::light_matrix(light, unit_bounds(), 512);
  for (int k = 0; k < 8; ++k) {
    const Vector3f p = (matrix * unit_bounds().corner(k).homogeneous()).head<3>();
    EXPECT_GT(p.minCoeff(), 0) << "corner " << k;
    EXPECT_LT(p.maxCoeff(), 1) << "corner " << k;
  }
  // Depth grows away from the light.
  EXPECT_LT((matrix * light.key.homogeneous()).z(), (matrix * Vector3f(-light.key).homogeneous()).z());
}

}  // namespace
