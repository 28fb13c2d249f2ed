#include "render/bodies.h"

#include <algorithm>

#include "render/canvas.h"
#include "render/colour_map.h"
#include "render/light.h"

namespace render {
namespace {

constexpr std::string_view body_vertex = R"(
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

// Of either stage.
constexpr std::string_view surface_colours = R"(
uniform vec4 base;  // linear light, opacity
#ifdef COLOURED
uniform sampler2D colours;
vec3 albedo(float scaled) {
  float entries = float(textureSize(colours, 0).x);
  return textureLod(colours, vec2((clamp(scaled, 0.0, 1.0) * (entries - 1.0) + 0.5) / entries, 0.5), 0.0).rgb;
}
#else
vec3 albedo(float scaled) { return base.rgb; }
#endif

// The sRGB curve by square roots instead of powers: within a tenth of a level.
vec3 to_srgb(vec3 light) {
  light = clamp(light, 0.0, 1.0);
  vec3 root = sqrt(light);
  vec3 curve = 0.833773 * root + 0.298094 * sqrt(root) - 0.055326 * light - 0.076901;
  return mix(curve, 12.92 * light, lessThan(light, vec3(0.0031308)));
}
)";

constexpr std::string_view surface_inputs = R"(
in vec3 world;
in vec3 direction;
in float scaled;
out vec4 colour;
)";

// Diffuse light that creeps a little round the terminator (light wanders under the skin), a broad dim gloss, a narrow
// one, and a rim that mirrors the sky at grazing angles. Jelly takes more of all that, and glows where it is thin: at
// its rim, and away from the key light. All lights are taken to be seen; opacity carries the share of them that does
// not come from the key light (see Canvas).
constexpr std::string_view solid_light = R"(
uniform vec4 finish;   // creep, broad gloss, narrow gloss, glow
uniform float shaded;  // 0: lies in no shadow
vec3 towards_eye(vec3 world) { return eye.w > 0.5 ? -forward.xyz : normalize(eye.xyz - world); }

// At a point with unit normal n, seen from direction v.
vec4 shade(vec3 n, vec3 v, vec3 skin) {
  float away = 1.0 - max(dot(n, v), 0.0);
  vec3 deep = skin * skin / max(max(skin.r, max(skin.g, skin.b)), 0.02);
  skin = mix(skin, deep, 0.7 * finish.w * (1.0 - away));

  float above = 0.5 + 0.5 * dot(n, up.xyz);
  vec3 rest = mix(vec3(0.27, 0.25, 0.24), vec3(0.43, 0.45, 0.48), above);
  rest += vec3(0.86, 0.93, 1.00) * (0.20 * max(dot(n, fill.xyz), 0.0));
  rest += finish.w * (0.18 + 0.40 * away * away + 0.26 * max(-dot(n, key.xyz), 0.0));
  float facing = dot(n, key.xyz);
  float direct = max(facing, 0.0);
  float creep = max(facing + 0.45, 0.0) / 1.45;
  creep *= creep;
  vec3 tint = finish.x * (0.4 + 0.6 * skin);
  vec3 light = rest + vec3(1.00, 0.97, 0.93) * ((0.72 - 0.20 * finish.w) * direct) + tint * max(creep - direct, 0.0);
  rest += tint * (0.35 * creep);

  vec3 h = normalize(key.xyz + v);
  float glance = max(dot(n, h), 0.0);
  float g8 = glance * glance; g8 *= g8; g8 *= g8;
  float g32 = g8 * g8; g32 *= g32;
  float g64 = g32 * g32;
  float sharp = mix(g64, g64 * g64 * g64, finish.w);
  float gloss = (finish.y * g8 + finish.z * sharp) * step(0.0, facing);
  float graze = away * away;
  float rim = (0.20 + 0.25 * finish.w) * graze * graze * above * above;
  float code = most_rest * min(rest.g / light.g, 1.0);
  return vec4(to_srgb(skin * light + vec3(gloss + rim)), mix(1.0, code, shaded));
}
)";

constexpr std::string_view solid_fragment = R"(
void main() {
  vec3 n = normalize(direction);
  colour = shade(gl_FrontFacing ? n : -n, towards_eye(world), albedo(scaled));
}
)";

// Where triangles are as small as a few pixels, light is as good when it is computed at the vertices, and far cheaper.
constexpr std::string_view fine_vertex = R"(
uniform float open;  // 1: both sides are seen
out vec4 light;
void main() {
  vec3 v = towards_eye(position);
  vec3 n = normalize(normal);
  light = shade(open > 0.5 && dot(n, v) < 0.0 ? -n : n, v, albedo(value));
  gl_Position = world_to_clip * vec4(position, 1.0);
}
)";

constexpr std::string_view fine_fragment = R"(
in vec4 light;
out vec4 colour;
void main() { colour = light; }
)";

constexpr std::string_view inside_fragment = R"(
void main() {
  colour = vec4(to_srgb(albedo(scaled) * (0.42 + 0.35 * max(-dot(normalize(direction), key.xyz), 0.0))), most_rest);
}
)";

constexpr std::string_view flat_fragment = "void main() { colour = vec4(to_srgb(albedo(scaled)), base.a); }\n";

// Opaque towards its rim, clear in the middle, like a soap bubble.
constexpr std::string_view ghost_fragment = R"(
void main() {
  vec3 v = eye.w > 0.5 ? -forward.xyz : normalize(eye.xyz - world);
  float away = 1.0 - abs(dot(normalize(direction), v));
  colour = vec4(to_srgb(albedo(scaled)), base.a * (0.35 + 0.65 * away * away));
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
  for (const bool coloured : {false, true}) {
    const char* switches = coloured ? "#define COLOURED\n" : "\n";
    const auto make = [&](const Sources& fragment) {
      Sources pieces{switches, frame_block, opacity_code, surface_inputs, surface_colours};
      pieces.insert(pieces.end(), fragment.begin(), fragment.end());
      return make_program(gl, {frame_block, vertex_attributes, body_vertex}, pieces);
    };
    Programs& programs = coloured ? by_value_ : plain_;
    programs.solid = make({solid_light, solid_fragment});
    programs.fine = make_program(
        gl, {switches, frame_block, opacity_code, vertex_attributes, surface_colours, solid_light, fine_vertex},
        {fine_fragment});
    programs.inside = make({inside_fragment});
    programs.flat = make({flat_fragment});
    programs.ghost = make({ghost_fragment});
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

void Bodies::use_finish(const GlObject& program, const Surface& surface) const {
  const Eigen::Vector4f finish = surface.finish == Finish::jelly ? Eigen::Vector4f(0.60F, 0.06F, 0.75F, 1)
                                                                 : Eigen::Vector4f(0.42F, 0.035F, 0.10F, 0);
  gl_.Uniform4fv(gl_.GetUniformLocation(program.name(), "finish"), 1, finish.data());
  gl_.Uniform1f(gl_.GetUniformLocation(program.name(), "shaded"), surface.shadow ? 1 : 0);
}

void Bodies::draw_solid(const Surface& surface, const SurfaceBuffer& buffer, bool inside_shows) const {
  const Programs& programs = programs_for(surface);
  constexpr std::size_t many = 12000;
  const GlObject& program = buffer.triangle_count() > many ? programs.fine : programs.solid;
  use_surface(program, surface, 1);
  use_finish(program, surface);
  gl_.Uniform1f(gl_.GetUniformLocation(program.name(), "open"), buffer.closed() ? 0 : 1);
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

void Bodies::draw_hidden(const Surface& surface, const SurfaceBuffer& buffer) const {
  use_surface(programs_for(surface).flat, surface, 0.6F);
  gl_.DepthFunc(GL_GREATER);
  gl_.DepthMask(GL_FALSE);
  gl_.Enable(GL_CULL_FACE);
  gl_.CullFace(GL_BACK);
  begin_blending(gl_);
  buffer.draw_triangles();
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_CULL_FACE);
  gl_.DepthMask(GL_TRUE);
  gl_.DepthFunc(GL_LESS);
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

}  // namespace render
