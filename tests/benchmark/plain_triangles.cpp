// What the machine's rasteriser does at all, to compare `draw` with: 80,000 triangles of a ball in 1280x720, not
// indexed, lit by one light, without shadows, resolved and read back.
#include <benchmark/benchmark.h>

#include <vector>

#include "render/gl.h"
#include "tests/benchmark/ball.h"

namespace {

constexpr int frame_width = 1280, frame_height = 720;

// Places of a ball around the origin, which are normals too: three for each triangle.
std::vector<float> unindexed_ball() {
  const render::Surface ball = benchmarks::ball(200);
  std::vector<float> points;
  for (const std::uint32_t vertex : ball.triangles) {
    const float* at = &ball.positions[3 * vertex];
    points.insert(points.end(), {at[0], at[1] - 1, at[2]});
  }
  return points;
}

constexpr std::string_view vertex_stage = R"(
layout(location = 0) in vec3 position;
out vec3 normal;
void main() {
  normal = position;
  gl_Position = vec4(0.9 * position.xy * vec2(0.5625, 1.0), 0.5 * position.z, 1.0);
}
)";

constexpr std::string_view fragment_stage = R"(
in vec3 normal;
out vec4 colour;
void main() { colour = vec4(vec3(0.2 + 0.8 * max(dot(normalize(normal), vec3(0.577, 0.577, -0.577)), 0.0)), 1.0); }
)";

render::GlObject multisampled(const GladGLContext& gl, GLenum format, int samples) {
  render::GlObject buffer = render::make_renderbuffer(gl, format, frame_width, frame_height);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, frame_width, frame_height);
  return buffer;
}

struct Target {
  render::GlObject colour, depth, framebuffer;
};

Target make_target(const GladGLContext& gl, int samples) {
  Target target{multisampled(gl, GL_RGBA8, samples), multisampled(gl, GL_DEPTH_COMPONENT24, samples),
                render::make_framebuffer(gl)};
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target.colour.name());
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth.name());
  render::check_framebuffer(gl, "benchmark");
  return target;
}

void plain_triangles(benchmark::State& state) {
  const auto context = render::make_offscreen_context();
  const GladGLContext gl = render::load_gl(*context);
  const Target drawn = make_target(gl, static_cast<int>(state.range(0))), picture = make_target(gl, 0);
  const render::GlObject program = render::make_program(gl, {vertex_stage}, {fragment_stage});
  const render::GlObject vertex_array = render::make_vertex_array(gl), vertices = render::make_buffer(gl);
  const std::vector<float> points = unindexed_ball();
  gl.Viewport(0, 0, frame_width, frame_height);
  gl.ClearColor(1, 1, 1, 1);
  gl.Enable(GL_DEPTH_TEST);
  gl.UseProgram(program.name());
  gl.BindVertexArray(vertex_array.name());
  for (auto _ : state) {
    render::fill_buffer(gl, GL_ARRAY_BUFFER, vertices, points.data(), points.size() * sizeof(float));
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl.BindFramebuffer(GL_FRAMEBUFFER, drawn.framebuffer.name());
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(points.size() / 3));
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, picture.framebuffer.name());
    gl.BlitFramebuffer(0, 0, frame_width, frame_height, 0, 0, frame_width, frame_height, GL_COLOR_BUFFER_BIT,
                       GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer.name());
    benchmark::DoNotOptimize(render::read_pixels(gl, frame_width, frame_height));
  }
}

BENCHMARK(plain_triangles)->Arg(0)->Arg(4)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
