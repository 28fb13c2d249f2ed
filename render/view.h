// From the scene to the screen: the matrices of a camera, and what a frame extends over.
#pragma once

#include <Eigen/Core>

#include "render/frame.h"

namespace render {

inline Eigen::Vector3f to_vector(const Point& p) {
  return {p[0], p[1], p[2]};
}

// An axis-aligned box; empty (low > high) until something is added.
struct Bounds {
  Eigen::Vector3f low = Eigen::Vector3f::Constant(1e30F);
  Eigen::Vector3f high = Eigen::Vector3f::Constant(-1e30F);

  bool empty() const { return low.x() > high.x(); }
  void add(const Eigen::Vector3f& point);
  // Corner k of eight: bit 0, 1, 2 of k chooses high in x, y, z.
  Eigen::Vector3f corner(int k) const;
};

// Everything solid in the frame: surfaces, ghosts, spheres, arrows, markers; not the ground.
Bounds bounds_of(const Frame& frame);

// A camera at work on a picture of given width/height.
struct View {
  Eigen::Matrix4f world_to_clip;
  Eigen::Vector3f eye, right, up, forward;  // forward, right, up: orthonormal
  Eigen::Vector3f target;
  bool orthographic = false;
  float near_distance = 0.1F, far_distance = 100;  // clip planes, along forward
  float extent = 1;                                // visible height at the target

  // Window coordinates of a point, origin top left, pixels; third: depth along forward (negative: behind the eye).
  Eigen::Vector3f to_window(const Eigen::Vector3f& point, int width, int height) const;
};

// Throws std::invalid_argument when the camera has no direction (eye = target, up along the view, numbers that are
// not finite, an angle outside (0, 180), a height <= 0).
View make_view(const Camera& camera, float aspect, const Bounds& bounds);

}  // namespace render
