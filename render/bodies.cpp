#include "render/bodies.h"

#include <algorithm>

#include "render/colour_map.h"
#include "render/light.h"
#include "render/visibility.h"

namespace render {
namespace {

constexpr std::string_view vertex_stage = R"(
out vec3 world;
out vec3 direction;  // of the normal
out float scaled;    // value on the colour scale
void main() {
  world = position;
  direction = normal;
  scaled = value;
  gl_Position = world_to_clip * vec4(position, 1.0);
}
)";

constexpr std::string_view surface_inputs = R"(
in vec3 world;
in vec3 direction;
in float scaled;
uniform vec4 base;    // linear light, opacity
out vec4 colour;

#ifdef COLOURED
uniform sampler2D colours;
vec3 albedo() {
  float entries = float(textureSize(colours, 0).x);
  return textureLod(colours, vec2((clamp(scaled, 0.0, 1.0) * (entries - 1.0) + 0.5) / entries, 0.5), 0.0).rgb;
}
#else
vec3 albedo() { return base.rgb; }
#endif

// The sRGB curve by square roots instead of powers: within a tenth of a level.
vec3 to_srgb(vec3 light) {
  light = clamp(light, 0.0, 1.0);
  vec3 root = sqrt(light);
  vec3 curve = 0.833773 * root + 0.298094 * sqrt(root) - 0.055326 * light - 0.076901;
  return mix(curve, 12.92 * light, lessThan(light, vec3(0.0031308)));
}
)";

// Rubber: diffuse light that creeps a little round the terminator (light wanders under the skin), a broad dim gloss,
// a narrow one, and a rim that mirrors the sky at grazing angles.
constexpr std::string_view solid_fragment = R"(
uniform ivec2 origin;
void main() {
  vec3 v = eye.w > 0.5 ? -forward.xyz : normalize(eye.xyz - world);
  vec3 n = normalize(direction);
  if (!gl_FrontFacing) n = -n;
  vec2 lit = visible(origin);
  vec3 skin = albedo();

  float facing = dot(n, key.xyz);
  float direct = max(facing, 0.0) * lit.x;
  float creep = max(facing + 0.45, 0.0) / 1.45;
  creep = creep * creep * mix(0.35, 1.0, lit.x) - max(facing, 0.0) * lit.x;
  vec3 light = vec3(1.00, 0.97, 0.93) * (0.72 * direct);
  light += (0.4 + 0.6 * skin) * (0.42 * max(creep, 0.0));
  light += vec3(0.86, 0.93, 1.00) * (0.20 * max(dot(n, fill.xyz), 0.0) * lit.y);
  float above = 0.5 + 0.5 * dot(n, up.xyz);
  light += mix(vec3(0.27, 0.25, 0.24), vec3(0.43, 0.45, 0.48), above) * lit.y;

  vec3 h = normalize(key.xyz + v);
  float glance = max(dot(n, h), 0.0);
  float g8 = glance * glance; g8 *= g8; g8 *= g8;
  float g32 = g8 * g8; g32 *= g32;
  float gloss = (0.035 * g8 + 0.10 * g32 * g32) * lit.x * step(0.0, facing);
  float away = 1.0 - max(dot(n, v), 0.0);
  away *= away;
  float rim = away * away * (0.40 * above * above) * lit.y * lit.y;
  colour = vec4(to_srgb(skin * light + vec3(gloss + 0.5 * rim)), 1.0);
}
)";

constexpr std::string_view inside_fragment = R"(
void main() { colour = vec4(to_srgb(albedo() * (0.42 + 0.35 * max(-dot(normalize(direction), key.xyz), 0.0))), 1.0); }
)";

constexpr std::string_view flat_fragment = "void main() { colour = vec4(to_srgb(albedo()), base.a); }\n";

// Opaque towards its rim, clear in the middle, like a soap bubble.
constexpr std::string_view ghost_fragment = R"(
void main() {
  vec3 v = eye.w > 0.5 ? -forward.xyz : normalize(eye.xyz - world);
  float away = 1.0 - abs(dot(normalize(direction), v));
  colour = vec4(to_srgb(albedo()), base.a * (0.35 + 0.65 * away * away));
}
)";

constexpr std::string_view lines_vertex = R"(
void main() {
  vec3 nearer = eye.w > 0.5 ? position - forward.xyz * (0.002 * forward.w) : mix(position, eye.xyz, 0.002);
  gl_Position = world_to_clip * vec4(nearer, 1.0);
}
)";

constexpr std::string_view lines_fragment = R"(
uniform vec4 ink;  // sRGB, opacity
out vec4 colour;
void main() { colour = ink; }
)";

}  // namespace

Bodies::Bodies(const GladGLContext& gl)
    : gl_(gl), lines_(make_program(gl, {frame_block, vertex_attributes, lines_vertex}, {lines_fragment})) {
  const auto make = [&](const char* switches, const Sources& fragment) {
    Sources pieces{switches, frame_block};
    pieces.insert(pieces.end(), fragment.begin(), fragment.end());
    return make_program(gl, {frame_block, vertex_attributes, vertex_stage}, pieces);
  };
  for (const bool coloured : {false, true}) {
    const char* switches = coloured ? "#define COLOURED\n" : "\n";
    Programs& programs = coloured ? by_value_ : plain_;
    programs.solid = make(switches, {visibility_lookup, surface_inputs, solid_fragment});
    programs.inside = make(switches, {surface_inputs, inside_fragment});
    programs.flat = make(switches, {surface_inputs, flat_fragment});
    programs.ghost = make(switches, {surface_inputs, ghost_fragment});
  }
  float widths[2] = {1, 1};
  gl.GetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widths);
  widest_line_ = widths[1];
}

const Bodies::Programs& Bodies::programs_for(const Surface& surface) const {
  return surface.values.empty() ? plain_ : by_value_;
}

void Bodies::use_scale(const ColourScale* scale) {
  if (scale == nullptr || scale->map == map_) return;
  map_ = scale->map;
  constexpr int entries = 256;
  std::vector<float> linear;
  for (const std::uint8_t c : colour_table(map_, entries)) linear.push_back(to_linear(static_cast<float>(c) / 255));
  colours_ = make_texture(gl_, {GL_RGB32F, entries, 1, GL_RGB, GL_FLOAT, GL_LINEAR}, linear.data());
}

void Bodies::use_surface(const GlObject& program, const Surface& surface, float opacity) const {
  gl_.UseProgram(program.name());
  const Eigen::Vector3f base = to_linear(surface.colour);
  gl_.Uniform4f(gl_.GetUniformLocation(program.name(), "base"), base.x(), base.y(), base.z(), opacity);
  if (!surface.values.empty()) use_texture(gl_, program, "colours", 1, colours_);
}

void Bodies::draw_solid(const Surface& surface, const SurfaceBuffer& buffer, const GlObject& visibility,
                        const Rect& region, bool inside_shows) const {
  const Programs& programs = programs_for(surface);
  use_surface(programs.solid, surface, 1);
  use_texture(gl_, programs.solid, "visibility", 0, visibility);
  gl_.Uniform2i(gl_.GetUniformLocation(programs.solid.name(), "origin"), region.x, region.y);
  if (!buffer.closed()) {
    buffer.draw_triangles();
    return;
  }
  gl_.Enable(GL_CULL_FACE);
  gl_.CullFace(GL_BACK);
  buffer.draw_triangles();
  if (inside_shows) {
    // Lit simply, because with multisampling all of it is shaded, seen or not.
    use_surface(programs.inside, surface, 1);
    gl_.CullFace(GL_FRONT);
    buffer.draw_triangles();
  }
  gl_.Disable(GL_CULL_FACE);
}

void Bodies::draw_flat(const Surface& surface, const SurfaceBuffer& buffer) const {
  use_surface(programs_for(surface).flat, surface, 1);
  buffer.draw_triangles();
}

// Depth first, so that the ghost's far side does not show through; pushed back, so that a body that stands where it
// rested hides it.
void Bodies::draw_ghost(const Surface& surface, const SurfaceBuffer& buffer) const {
  use_surface(programs_for(surface).ghost, surface, 0.55F);
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  gl_.PolygonOffset(1, 4);
  gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  buffer.draw_triangles();
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.DepthFunc(GL_EQUAL);
  begin_blending(gl_);
  buffer.draw_triangles();
  gl_.Disable(GL_BLEND);
  gl_.DepthFunc(GL_LESS);
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
}

void Bodies::use_lines(const Eigen::Vector4f& colour, float width) const {
  gl_.UseProgram(lines_.name());
  gl_.Uniform4fv(gl_.GetUniformLocation(lines_.name(), "ink"), 1, colour.data());
  gl_.LineWidth(std::clamp(width, 1.0F, widest_line_));
  begin_blending(gl_);
}

void Bodies::draw_edges(const SurfaceBuffer& buffer, const Eigen::Vector4f& colour, float width) const {
  use_lines(colour, width);
  buffer.draw_edges();
  gl_.Disable(GL_BLEND);
}

void Bodies::draw_outline(const SurfaceBuffer& buffer, const Eigen::Vector4f& colour, float width) const {
  use_lines(colour, width);
  buffer.draw_outline();
  gl_.Disable(GL_BLEND);
}

}  // namespace render
