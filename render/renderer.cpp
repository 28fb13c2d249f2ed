#include "render/renderer.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>
#include <string>

#include "render/backdrop.h"
#include "render/bodies.h"
#include "render/canvas.h"
#include "render/check.h"
#include "render/glyphs.h"
#include "render/light.h"
#include "render/overlay.h"
#include "render/shadow_map.h"
#include "render/view.h"
#include "render/visibility.h"

namespace render {
namespace {

int checked_size(int pixels, const char* what) {
  if (pixels < 1 || pixels > 8192) {
    throw std::invalid_argument(std::string("picture ") + what + " is " + std::to_string(pixels) +
                                " pixels, must be 1 to 8192");
  }
  return pixels;
}

int checked_samples(int samples) {
  if (samples != 1 && samples != 2 && samples != 4 && samples != 8) {
    throw std::invalid_argument("samples per pixel are " + std::to_string(samples) + ", must be 1, 2, 4 or 8");
  }
  return samples;
}

// The pixels that a set of points covers, with a margin; all of the picture when one of them lies behind the eye.
Rect rect_around(const std::vector<Eigen::Vector3f>& points, const View& view, int width, int height, float margin) {
  Eigen::Vector2f low(1e9F, 1e9F), high(-1e9F, -1e9F);
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3f window = view.to_window(point, width, height);
    if (!view.orthographic && window.z() < view.near_distance) return {0, 0, width, height};
    const Eigen::Vector2f pixel(window.x(), static_cast<float>(height) - window.y());
    low = low.cwiseMin(pixel);
    high = high.cwiseMax(pixel);
  }
  const Eigen::Vector2f most(static_cast<float>(width), static_cast<float>(height));
  low = (low.array() - margin).max(0).min(most.array());
  high = (high.array() + margin).max(0).min(most.array());
  const int x = static_cast<int>(std::floor(low.x())), y = static_cast<int>(std::floor(low.y()));
  return {x, y, static_cast<int>(std::ceil(high.x())) - x, static_cast<int>(std::ceil(high.y())) - y};
}

}  // namespace

// The stages of a picture, and what they keep from frame to frame.
struct Renderer::Parts {
  Parts(Context& context_, int width, int height, int samples)
      : context(context_),
        gl(load_gl(context_)),
        canvas(gl, width, height, samples),
        backdrop(gl),
        shadow(gl),
        visibility(gl, width, height),
        bodies(gl),
        markers(gl),
        overlay(gl, width, height),
        block(make_buffer(gl)) {}

  void update(const Frame& frame, const View& view);
  void upload_block(const Frame& frame, const View& view, const Bounds& bounds);
  Rect shaded_rect(const Frame& frame, const View& view, const Bounds& bounds, const Light& light) const;
  void draw_bodies(const Frame& frame, const View& view, const Rect& region);

  Context& context;
  GladGLContext gl;
  Canvas canvas;
  Backdrop backdrop;
  ShadowMap shadow;
  Visibility visibility;
  Bodies bodies;
  Markers markers;
  Overlay overlay;
  GlObject block;
  std::deque<SurfaceBuffer> buffers;  // solids, then ghosts; a deque, because lists hold pointers into it
  std::vector<Surface> glyphs;        // obstacles and arrows of the frame
  std::vector<const Surface*> solids;
  SurfaceList lit;  // buffers of the solids that are not flat
  Rect visible;
  bool inside_shows = true;  // of a closed surface; known once the visibility has been drawn
};

// Brings every surface of the frame to the graphics side.
void Renderer::Parts::update(const Frame& frame, const View& view) {
  glyphs = arrow_surfaces(frame.arrows, view.extent);
  for (const SphereObstacle& sphere : frame.spheres) glyphs.push_back(sphere_surface(sphere));
  solids.clear();
  for (const Surface& surface : frame.surfaces) solids.push_back(&surface);
  for (const Surface& glyph : glyphs) solids.push_back(&glyph);
  const std::size_t needed = solids.size() + frame.ghosts.size();
  while (buffers.size() < needed) buffers.emplace_back(gl);
  const ColourScale* scale = frame.scale ? &*frame.scale : nullptr;
  bodies.use_scale(scale);
  lit.clear();
  for (std::size_t i = 0; i < solids.size(); ++i) {
    buffers[i].update(*solids[i], scale);
    if (!solids[i]->flat) lit.push_back(&buffers[i]);
  }
  for (std::size_t i = 0; i < frame.ghosts.size(); ++i) buffers[solids.size() + i].update(frame.ghosts[i], scale);
}

// Where light is blocked: around the solids, and where their shadow falls on ground and planes.
Rect Renderer::Parts::shaded_rect(const Frame& frame, const View& view, const Bounds& bounds,
                                  const Light& light) const {
  if (lit.empty() || (!frame.look.shadow && !frame.look.occlusion)) return {};
  std::vector<Eigen::Vector3f> points;
  const auto fall = [&](const Eigen::Vector3f& corner, const Point& point, const Point& direction) {
    const Eigen::Vector3f normal = to_vector(direction).normalized();
    const float height = normal.dot(corner - to_vector(point)), slant = normal.dot(light.key);
    if (slant > 0.05F && height > 0) points.emplace_back(corner - light.key * (height / slant));
  };
  for (int k = 0; k < 8; ++k) {
    points.push_back(bounds.corner(k));
    if (frame.ground) fall(bounds.corner(k), frame.ground->point, frame.ground->normal);
    for (const PlaneObstacle& plane : frame.planes) fall(bounds.corner(k), plane.point, plane.normal);
  }
  return rect_around(points, view, canvas.width(), canvas.height(), 0.08F * static_cast<float>(canvas.height()));
}

void Renderer::Parts::upload_block(const Frame& frame, const View& view, const Bounds& bounds) {
  const Light light = light_of(frame, view);
  visible = shaded_rect(frame, view, bounds, light);
  const auto four = [](const Eigen::Vector3f& v, float w) { return Eigen::Vector4f(v.x(), v.y(), v.z(), w); };
  const auto real = [](int i) { return static_cast<float>(i); };
  FrameBlock data;
  data.world_to_clip = view.world_to_clip;
  data.clip_to_world = view.world_to_clip.cast<double>().inverse().cast<float>();
  data.world_to_light = bounds.empty() ? Eigen::Matrix4f::Identity() : light_matrix(light, bounds, ShadowMap::texels);
  data.eye = four(view.eye, view.orthographic ? 1 : 0);
  data.forward = four(view.forward, view.extent);
  data.key = four(light.key, 0);
  data.fill = four(light.fill, 0);
  data.up = four(light.up, 0);
  data.depth_range = {view.near_distance, view.far_distance, 0, 0};
  data.size = {real(canvas.width()), real(canvas.height()), real(visibility.width()), real(visibility.height())};
  // Without a buffer no pixel lies inside.
  data.visible_rect = {1, 1, 0, 0};
  if (!visible.empty()) {
    data.visible_rect = {real(visible.x), real(visible.y), real(visible.x + visible.width),
                         real(visible.y + visible.height)};
  }
  fill_buffer(gl, GL_UNIFORM_BUFFER, block, &data, sizeof(data));
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, block.name());
}

void Renderer::Parts::draw_bodies(const Frame& frame, const View& view, const Rect& region) {
  const float pixel = std::max(1.0F, static_cast<float>(canvas.height()) / 720);
  backdrop.draw_depth(frame, view);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (solids[i]->flat) {
      gl.DepthFunc(GL_LEQUAL);
      bodies.draw_flat(*solids[i], buffers[i]);
      gl.DepthFunc(GL_LESS);
    } else {
      bodies.draw_solid(*solids[i], buffers[i], visibility.texture(), region, inside_shows);
    }
  }
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (frame.look.wireframe) bodies.draw_edges(buffers[i], {0.07F, 0.08F, 0.11F, 0.55F}, pixel);
    if (solids[i]->flat) bodies.draw_outline(buffers[i], {0.10F, 0.12F, 0.15F, 1}, 1.6F * pixel);
  }
  markers.draw(frame.markers, std::max(3.0F, 0.0125F * static_cast<float>(canvas.height())));
  for (std::size_t i = 0; i < frame.ghosts.size(); ++i) {
    const SurfaceBuffer& buffer = buffers[solids.size() + i];
    bodies.draw_ghost(frame.ghosts[i], buffer);
    bodies.draw_outline(buffer, {0.45F, 0.48F, 0.52F, 0.8F}, pixel);
  }
}

Renderer::Renderer(Context& context, int width, int height, int samples)
    : parts_(std::make_unique<Parts>(context, checked_size(width, "width"), checked_size(height, "height"),
                                     checked_samples(samples))) {}

Renderer::~Renderer() {
  try {
    parts_->context.make_current();
  } catch (const std::runtime_error&) {
    // The context is gone, and its objects with it.
  }
}

Image Renderer::draw(const Frame& frame) {
  Parts& p = *parts_;
  check(frame);
  const int width = p.canvas.width(), height = p.canvas.height();
  const Bounds bounds = bounds_of(frame);
  const View view = make_view(frame.camera, static_cast<float>(width) / static_cast<float>(height), bounds);
  p.context.make_current();
  p.update(frame, view);
  p.upload_block(frame, view, bounds);
  p.inside_shows = true;
  if (!p.visible.empty()) {
    if (frame.look.shadow) p.shadow.draw(p.lit);
    p.inside_shows = p.visibility.draw(frame, view, p.lit, p.backdrop, p.shadow, p.visible);
  }
  p.canvas.draw_into_picture();
  p.backdrop.draw(frame, view, p.visibility.texture(), p.visible);
  Rect region;
  if (!bounds.empty()) {
    std::vector<Eigen::Vector3f> corners;
    for (int k = 0; k < 8; ++k) corners.push_back(bounds.corner(k));
    region = rect_around(corners, view, width, height, 0.02F * static_cast<float>(height) + 4);
  }
  if (!region.empty()) {
    p.canvas.draw_into_region(region);
    p.draw_bodies(frame, view, region);
    p.canvas.resolve();
  }
  p.overlay.draw(frame, view);
  return p.canvas.read();
}

}  // namespace render
