// Where the light of a frame comes from, and what the shaders know of a frame.
#pragma once

#include <Eigen/Core>
#include <string_view>

#include "render/frame.h"
#include "render/view.h"

namespace render {

// A key light over the viewer's left shoulder and a fill from the right, so that every view is lit well.
struct Light {
  Eigen::Vector3f key, fill;  // unit, towards the light
  Eigen::Vector3f up;         // unit: the ground's normal, else the camera's up
};
Light light_of(const Frame& frame, const View& view);

// World to the shadow map's cube, [0, 1]^3, looking along the key light at `casters` (which must not be empty). Sizes
// and places are rounded to a grid, so that shadows do not crawl while a body deforms.
Eigen::Matrix4f light_matrix(const Light& light, const Bounds& casters, int texels);

// One frame's numbers, as the shaders' uniform block has them (std140: only matrices and four-vectors).
struct FrameBlock {
  Eigen::Matrix4f world_to_clip;
  Eigen::Matrix4f clip_to_world;
  Eigen::Matrix4f world_to_light;
  Eigen::Vector4f eye;          // xyz: eye; w: 1 for a parallel camera, else 0
  Eigen::Vector4f forward;      // xyz: unit, along the view; w: visible height at the target
  Eigen::Vector4f key;          // xyz: unit, towards the key light
  Eigen::Vector4f fill;         // xyz: unit, towards the fill light
  Eigen::Vector4f up;           // xyz: unit
  Eigen::Vector4f depth_range;  // near, far
  Eigen::Vector4f size;         // picture width, height; width, height of the visibility buffer
  Eigen::Vector4f texel;        // 1 over each of size
};

// The same in GLSL, with what every stage needs of it.
inline constexpr std::string_view frame_block = R"(
layout(std140) uniform Frame {
  mat4 world_to_clip;
  mat4 clip_to_world;
  mat4 world_to_light;
  vec4 eye;
  vec4 forward;
  vec4 key;
  vec4 fill;
  vec4 up;
  vec4 depth_range;
  vec4 size;
  vec4 texel;
};

// Distance along the view from the depth d of a pixel, 0 to 1, and how it grows with d.
float eye_depth(float d) {
  float n = depth_range.x, f = depth_range.y;
  return eye.w > 0.5 ? n + d * (f - n) : n * f / (f - d * (f - n));
}
float eye_depth_slope(float z) {
  float n = depth_range.x, f = depth_range.y;
  return eye.w > 0.5 ? f - n : z * z * (f - n) / (n * f);
}
)";

}  // namespace render
