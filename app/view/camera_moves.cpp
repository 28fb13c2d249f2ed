#include "app/view/camera_moves.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/picture/stage.h"

namespace app {
namespace {

using sim::Vec3;

struct Axes {
  explicit Axes(const render::Camera& camera)
      : forward((to_vec3(camera.target) - to_vec3(camera.eye)).normalized()),
        right(forward.cross(to_vec3(camera.up)).normalized()),
        up(right.cross(forward)) {}
  Vec3 forward, right, up;
};

}  // namespace

MoveCamera orbit(const render::Camera& camera, double right, double down) {
  if (camera.orthographic) return pan(camera, right, down);
  constexpr double turn = std::numbers::pi;  // by a drag over the height of the picture
  constexpr double least = 0.05;             // radians between the line of sight and `up`
  const Vec3 up = to_vec3(camera.up).normalized(), target = to_vec3(camera.target);
  const Vec3 arm = Eigen::AngleAxisd(-turn * right, up) * (to_vec3(camera.eye) - target);
  const double polar = std::acos(std::clamp(arm.normalized().dot(up), -1.0, 1.0));
  const double wanted = std::clamp(polar - turn * down, least, std::numbers::pi - least);
  const Vec3 side = up.cross(arm).normalized();
  return {target + Eigen::AngleAxisd(wanted - polar, side) * arm, target, std::nullopt};
}

MoveCamera pan(const render::Camera& camera, double right, double down) {
  const Axes axes(camera);
  const Vec3 shift = visible_height(camera) * (down * axes.up - right * axes.right);
  const Vec3 target = to_vec3(camera.target) + shift;
  if (camera.orthographic) return {std::nullopt, target, camera.height};
  return {to_vec3(camera.eye) + shift, target, std::nullopt};
}

MoveCamera zoom(const render::Camera& camera, double notches) {
  const double factor = std::pow(0.9, notches);
  const Vec3 target = to_vec3(camera.target);
  if (camera.orthographic) return {std::nullopt, target, factor * camera.height};
  return {target + factor * (to_vec3(camera.eye) - target), target, std::nullopt};
}

render::Camera moved(render::Camera camera, const MoveCamera& move) {
  if (camera.orthographic) {
    // The eye stands before the target, as far as the picture is high.
    camera.height = static_cast<float>(move.height.value_or(camera.height));
    const Vec3 target = move.target.value_or(to_vec3(camera.target));
    camera.target = to_point(target);
    camera.eye = to_point(target + camera.height * Vec3::UnitZ());
    return camera;
  }
  if (move.eye) camera.eye = to_point(*move.eye);
  if (move.target) camera.target = to_point(*move.target);
  return camera;
}

}  // namespace app
