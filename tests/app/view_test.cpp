#include "render/view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/picture/stage.h"

namespace app {
namespace {

Vec3 vec(const render::Point& p) {
  return {p[0], p[1], p[2]};
}

const Eigen::AlignedBox3d box{Vec3(-1, 0, 2), Vec3(3, 1, 3)};

// Whether a point lies within the picture of a perspective camera.
bool is_seen(const render::Camera& camera, const Vec3& point, double aspect) {
  const Vec3 ahead = (vec(camera.target) - vec(camera.eye)).normalized();
  const Vec3 right = ahead.cross(vec(camera.up)).normalized();
  const Vec3 ray = point - vec(camera.eye);
  const double depth = ray.dot(ahead);
  const double slope = std::tan(camera.field_of_view / 2 * std::numbers::pi / 180);
  return depth > 0 && std::abs(ray.dot(right.cross(ahead))) < slope * depth &&
         std::abs(ray.dot(right)) < aspect * slope * depth;
}

TEST(View, AllIsSeenWhateverTheShapeOfThePicture) {
  for (const double aspect : {16.0 / 9, 1.0, 0.25}) {
    for (const Vec3& up : {Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 0)}) {
      const render::Camera view = view_of({}, {.up = up}, box, 3, aspect);
      for (int i = 0; i < 8; ++i) {
        EXPECT_TRUE(is_seen(view, box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)), aspect)) << aspect;
      }
      EXPECT_GT((vec(view.eye) - vec(view.target)).dot(up), 0);  // from above
    }
  }
}

TEST(View, WhatTheSceneNamesIsTaken) {
  Camera camera;
  camera.eye = Vec3(2, 0.5, 7);
  camera.target = Vec3(2, 0, 0.5);
  camera.fov = 50;
  const render::Camera view = view_of(camera, {}, box, 3, 1.5);
  EXPECT_EQ(view.eye, (render::Point{2, 0.5F, 7}));
  EXPECT_EQ(view.target, (render::Point{2, 0, 0.5F}));
  EXPECT_FLOAT_EQ(view.field_of_view, 50);
  EXPECT_FALSE(view.orthographic);
}

TEST(View, AWidePlaneSceneFitsInWidth) {
  const Eigen::AlignedBox3d wide{Vec3(0, 0, 0), Vec3(8, 1, 0)};
  const render::Camera view = view_of({}, {}, wide, 2, 2.0);
  EXPECT_TRUE(view.orthographic);
  EXPECT_EQ(view.target, (render::Point{4, 0.5F, 0}));
  EXPECT_FLOAT_EQ(view.height, 5);  // 8 m and a quarter more, over the aspect
}

TEST(View, APartOfThePictureShowsWhatAllOfItWould) {
  render::Camera view = view_of({}, {}, box, 3, 1.5), part = view;
  place_in({0.5, 0.25, 1, 0.75}, 1.5, part);
  const render::View all = render::make_view(view, 1.5F, {}), right = render::make_view(part, 1.5F, {});
  const Eigen::Vector3f middle = box.center().cast<float>();
  EXPECT_NEAR(all.to_window(middle, 300, 200).x(), 150, 0.5);
  EXPECT_NEAR(right.to_window(middle, 300, 200).x(), 225, 0.5);
  EXPECT_NEAR(right.to_window(middle, 300, 200).y(), 100, 0.5);
  const Eigen::Vector3f up = middle + 0.1F * all.up;
  EXPECT_NEAR((all.to_window(middle, 300, 200) - all.to_window(up, 300, 200)).norm(),
              2 * (right.to_window(middle, 300, 200) - right.to_window(up, 300, 200)).norm(), 0.2);
}

}  // namespace
}  // namespace app
