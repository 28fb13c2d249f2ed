#include "render/renderer.h"

#include <Eigen/LU>
#include <algorithm>
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

// Every `step`-th vertex.
Eigen::Map<const Eigen::Matrix3Xf, 0, Eigen::OuterStride<>> vertices_of(const Surface& surface, Eigen::Index step) {
  const auto count = static_cast<Eigen::Index>(surface.positions.size() / 3);
  return {surface.positions.data(), 3, (count + step - 1) / step, Eigen::OuterStride<>(3 * step)};
}

}  // namespace

// The stages of a picture, and what they keep from frame to frame.
struct Renderer::Parts {
  Parts(Context& context_, int width, int height, int samples)
      : context(context_),
        gl(load_gl(context_)),
        canvas(gl, width, height, samples),
        backdrop(gl, width, height),
        shadow(gl),
        visibility(gl, width, height),
        bodies(gl),
        markers(gl),
        overlay(gl, width, height),
        block(make_buffer(gl)) {}

  void update(const Frame& frame, const View& view);
  void find_rects(const Frame& frame, const View& view, const Light& light);
  void upload_block(const View& view, const Bounds& bounds, const Light& light);
  void draw_light(const Frame& frame, const View& view);
  void draw_bodies(const Frame& frame, const View& view);

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
  std::vector<Surface> glyphs;        // arrows and obstacles of the frame
  std::size_t arrow_kinds = 0;        // how many of them, at the beginning, are arrows
  std::vector<const Surface*> solids;
  SurfaceList lit;           // buffers of the solids that are not flat
  Rect region;               // what solids, ghosts and markers cover
  Shades shades;             // where ground and planes can be darkened
  float marker_size = 1;     // pixels
  bool shaded = false;       // whether the visibility buffer has been drawn
  bool inside_shows = true;  // of a closed surface
};

// Brings every surface of the frame to the graphics side.
void Renderer::Parts::update(const Frame& frame, const View& view) {
  glyphs = arrow_surfaces(frame.arrows, view.extent);
  arrow_kinds = glyphs.size();
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
    if (!solids[i]->flat && solids[i]->shadow) lit.push_back(&buffers[i]);
  }
  for (std::size_t i = 0; i < frame.ghosts.size(); ++i) buffers[solids.size() + i].update(frame.ghosts[i], scale);
}

void Renderer::Parts::find_rects(const Frame& frame, const View& view, const Light& light) {
  const int width = canvas.width(), height = canvas.height();
  marker_size = std::max(3.0F, 0.0125F * static_cast<float>(height));
  region = {};
  for (const Surface* solid : solids) {
    // What is drawn round reaches a little beyond its vertices.
    const float margin = solid->round ? 4 + 0.03F * static_cast<float>(height) : 4;
    region = united(region, rect_of(vertices_of(*solid, 1), view, width, height, margin));
  }
  for (const Surface& ghost : frame.ghosts) {
    region = united(region, rect_of(vertices_of(ghost, 1), view, width, height, 4));
  }
  for (const Marker& marker : frame.markers) {
    region = united(region, rect_of(to_vector(marker.at), view, width, height, marker_size));
  }
  shades = {{}, std::vector<Rect>(frame.planes.size())};
  if (lit.empty() || (!frame.look.shadow && !frame.look.occlusion)) return;
  if (!frame.planes.empty()) {
    // Planes and ground meet anywhere.
    shades.ground = {0, 0, width, height};
    std::fill(shades.planes.begin(), shades.planes.end(), shades.ground);
    return;
  }
  if (!frame.ground) return;
  for (const Surface* solid : solids) {
    // Some thousands of the vertices tell as much as all, given the margin.
    const auto vertices = vertices_of(*solid, 1 + static_cast<Eigen::Index>(solid->positions.size() / 3 / 4000));
    const Rect rect = shade_rect(frame.ground->point, frame.ground->normal, vertices, light.key, view, width, height,
                                 0.09F * static_cast<float>(height));
    shades.ground = united(shades.ground, rect);
  }
}

void Renderer::Parts::upload_block(const View& view, const Bounds& bounds, const Light& light) {
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
  data.texel = data.size.cwiseInverse();
  fill_buffer(gl, GL_UNIFORM_BUFFER, block, &data, sizeof(data));
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, block.name());
}

// Shadows and darkened creases, where there is something that they fall on.
void Renderer::Parts::draw_light(const Frame& frame, const View& view) {
  inside_shows = true;
  shaded = !lit.empty() && (frame.look.shadow || frame.look.occlusion);
  if (!shaded) return;
  Rect rect = united(region, shades.ground);
  for (const Rect& shade : shades.planes) rect = united(rect, shade);
  if (frame.look.shadow) shadow.draw(lit);
  inside_shows = visibility.draw(frame, view, lit, backdrop, shadow, rect);
}

void Renderer::Parts::draw_bodies(const Frame& frame, const View& view) {
  // Lines of a pixel weigh more in a small picture, and are lighter there.
  const float size = static_cast<float>(canvas.height()) / 720;
  const float pixel = std::max(1.0F, size), ink = 0.55F * std::clamp(size, 0.4F, 1.0F);
  backdrop.draw_depth(frame, view);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (solids[i]->flat) {
      gl.DepthFunc(GL_LEQUAL);
      bodies.draw_flat(*solids[i], buffers[i]);
      gl.DepthFunc(GL_LESS);
    } else {
      bodies.draw_solid(*solids[i], buffers[i], inside_shows);
    }
  }
  const std::size_t first_arrow = frame.surfaces.size();
  for (std::size_t i = first_arrow; i < first_arrow + arrow_kinds; ++i) bodies.draw_hidden(*solids[i], buffers[i]);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (frame.look.wireframe) bodies.draw_edges(buffers[i], {0.07F, 0.08F, 0.11F, ink}, pixel);
  }
  markers.draw(frame.markers, marker_size);
  for (std::size_t i = 0; i < frame.ghosts.size(); ++i) {
    bodies.draw_ghost(frame.ghosts[i], buffers[solids.size() + i]);
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
  paint(frame);
  return read();
}

Image Renderer::read() const {
  parts_->context.make_current();
  return parts_->canvas.read();
}

void Renderer::present(int x) const {
  parts_->context.make_current();
  parts_->canvas.copy_to_default(x);
}

void Renderer::paint(const Frame& frame) {
  Parts& p = *parts_;
  check(frame);
  const float aspect = static_cast<float>(p.canvas.width()) / static_cast<float>(p.canvas.height());
  const Bounds bounds = bounds_of(frame);
  const View view = make_view(frame.camera, aspect, bounds);
  const Light light = light_of(frame, view);
  p.context.make_current();
  p.update(frame, view);
  p.find_rects(frame, view, light);
  p.upload_block(view, bounds, light);
  p.draw_light(frame, view);
  p.backdrop.draw(frame, view, p.visibility.texture(), p.shades, p.canvas);
  if (!p.region.empty()) {
    p.canvas.draw_into_region(p.region);
    p.draw_bodies(frame, view);
    p.canvas.resolve(p.shaded ? &p.visibility.texture() : nullptr);
  }
  p.overlay.draw(frame, view);
}

}  // namespace render
