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

// One frame's numbers, named once for C++ and for the shaders' uniform block (std140: only matrices and four-vectors).
#define RENDER_FRAME_BLOCK(MATRIX, VECTOR)                                        \
  MATRIX(world_to_clip)                                                           \
  MATRIX(clip_to_world)                                                           \
  MATRIX(world_to_light)                                                          \
  VECTOR(eye)         /* xyz: eye; w: 1 for a parallel camera, else 0 */          \
  VECTOR(forward)     /* xyz: unit, along the view; w: visible height there */    \
  VECTOR(key)         /* xyz: unit, towards the key light */                      \
  VECTOR(fill)        /* xyz: unit, towards the fill light */                     \
  VECTOR(up)          /* xyz: unit */                                             \
  VECTOR(depth_range) /* near, far */                                             \
  VECTOR(size)        /* picture width, height; those of the visibility buffer */ \
  VECTOR(texel)       /* 1 over each of size */
#define RENDER_MATRIX(name) Eigen::Matrix4f name;
#define RENDER_VECTOR(name) Eigen::Vector4f name;
#define RENDER_GLSL_MATRIX(name) "mat4 " #name ";\n"
#define RENDER_GLSL_VECTOR(name) "vec4 " #name ";\n"

struct FrameBlock {
  RENDER_FRAME_BLOCK(RENDER_MATRIX, RENDER_VECTOR)
};

// The same in GLSL, with what every stage needs of it.
inline constexpr std::string_view frame_block =
    "layout(std140) uniform Frame {\n" RENDER_FRAME_BLOCK(RENDER_GLSL_MATRIX, RENDER_GLSL_VECTOR) "};\n" R"(
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
