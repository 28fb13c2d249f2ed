// Frames and sizes at the extremes, and pictures that do not depend on what was drawn before.
#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

#include "render/renderer.h"
#include "tests/render/shapes.h"

namespace {

using render::Frame;
using render::Image;
using render::Renderer;

// One of everything.
Frame full_frame() {
  Frame frame;
  frame.ground = render::Ground{{0, -0.93F, 0}, {0, 1, 0}};
  frame.camera.eye = {1.6F, 0.7F, 4.2F};
  frame.surfaces.push_back(shapes::bear(28));
  frame.surfaces[0].values.assign(frame.surfaces[0].positions.size() / 3, 3);
  frame.scale = render::ColourScale{"cividis", 0, 5, "stress", "kPa"};
  frame.ghosts.push_back(shapes::sphere({0.4F, 0, 0}, 0.5F));
  frame.planes.push_back({{0, 0, -1.5F}, {0, 0, 1}});
  frame.spheres.push_back({{1, -0.7F, 0}, 0.2F});
  frame.arrows.push_back({{0, 0.5F, 0}, {0, 1, 0}});
  frame.markers.push_back({{0, 0, 0.5F}});
  frame.labels.push_back({{0, 0.8F, 0}, "bear"});
  frame.strips.push_back({"energy", "J", {0, 1, 2}, {{"kinetic", {0, 1, std::nanf("")}}}, 4});
  frame.title = "One of everything";
  frame.caption = "t = 1 s\nE = 3 J";
  frame.look.wireframe = true;
  return frame;
}

TEST(Robustness, SameFrameSameBytes) {
  const Frame frame = full_frame();
  auto context = render::make_offscreen_context();
  Renderer renderer(*context, 320, 180);
  const Image first = renderer.draw(frame);
  EXPECT_EQ(renderer.draw(frame).rgba, first.rgba);
  // Another, larger body in between changes buffers, creases and the region that is multisampled.
  Frame other = frame;
  other.surfaces = {shapes::box({3, 2, 1}, 8, [](render::Point p) { return p; })};
  other.ghosts.clear();
  other.camera.eye = {2, 1, 3};
  EXPECT_NE(renderer.draw(other).rgba, first.rgba);
  EXPECT_EQ(renderer.draw(frame).rgba, first.rgba);
  // A renderer of its own, beside the first.
  auto second_context = render::make_offscreen_context();
  Renderer second(*second_context, 320, 180);
  EXPECT_EQ(second.draw(frame).rgba, first.rgba);
  EXPECT_EQ(renderer.draw(frame).rgba, first.rgba);
}

TEST(Robustness, SizesFromOnePixelUp) {
  const Frame frame = full_frame();
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {1, 500}, {500, 1}, {317, 181}, {4096, 4096}}) {
    auto context = render::make_offscreen_context();
    const Image image = Renderer(*context, width, height).draw(frame);
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    ASSERT_EQ(image.rgba.size(), 4 * static_cast<std::size_t>(width) * height);
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255) << "not opaque";
  }
}

TEST(Robustness, WrongSizesAreRefused) {
  auto context = render::make_offscreen_context();
  EXPECT_THROW(Renderer(*context, 0, 10), std::invalid_argument);
  EXPECT_THROW(Renderer(*context, 10, -1), std::invalid_argument);
  EXPECT_THROW(Renderer(*context, 10, 100000), std::invalid_argument);
  EXPECT_THROW(Renderer(*context, 10, 10, 3), std::invalid_argument);
  for (const int samples : {1, 2, 4, 8}) EXPECT_NO_THROW(Renderer(*context, 10, 10, samples));
}

TEST(Robustness, FramesWithLittleInThem) {
  auto context = render::make_offscreen_context();
  Renderer renderer(*context, 160, 90);
  Frame frame;
  const Image background = renderer.draw(frame);
  frame.surfaces.emplace_back();  // no vertices
  EXPECT_EQ(renderer.draw(frame).rgba, background.rgba);
  frame.surfaces[0].positions = {0, 0, 0};  // no triangles
  EXPECT_EQ(renderer.draw(frame).rgba, background.rgba);
  frame.surfaces[0].positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  frame.surfaces[0].triangles = {0, 1, 2};
  const Image triangle = renderer.draw(frame);
  EXPECT_NE(triangle.rgba, background.rgba);
  frame.surfaces[0].triangles = {2, 1, 0};  // seen from behind: still there
  EXPECT_NE(renderer.draw(frame).rgba, background.rgba);
  frame.surfaces[0].positions = {1, 1, 1, 1, 1, 1, 1, 1, 1};  // a point
  EXPECT_NO_THROW(renderer.draw(frame));
  frame.surfaces[0].positions = {0, 0, 50, 1, 0, 50, 0, 1, 50};  // behind the eye
  EXPECT_EQ(renderer.draw(frame).rgba, background.rgba);
}

TEST(Robustness, HalfAMillionTriangles) {
  Frame frame;
  frame.ground = render::Ground{{0, -1, 0}, {0, 1, 0}};
  frame.surfaces.push_back(shapes::sphere({0, 0, 0}, 1, 360));
  ASSERT_GE(frame.surfaces[0].triangles.size() / 3, 500000U);
  auto context = render::make_offscreen_context();
  Renderer renderer(*context, 640, 360);
  const Image fine = renderer.draw(frame);
  frame.surfaces = {shapes::sphere({0, 0, 0}, 1, 60)};
  const Image coarse = renderer.draw(frame);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < fine.rgba.size(); i += 4)
    differing += std::abs(fine.rgba[i] - coarse.rgba[i]) > 24 ? 1 : 0;
  EXPECT_LT(differing, fine.rgba.size() / 4 / 200);  // the same sphere
}

TEST(Robustness, InvertedBodyIsStillSeen) {
  // Turned inside out: all that faces the eye are insides.
  Frame frame;
  frame.surfaces.push_back(shapes::bear(28));
  auto context = render::make_offscreen_context();
  Renderer renderer(*context, 320, 180);
  const Image body = renderer.draw(frame);
  for (std::size_t i = 0; i < frame.surfaces[0].triangles.size(); i += 3) {
    std::swap(frame.surfaces[0].triangles[i], frame.surfaces[0].triangles[i + 1]);
  }
  const Image inverted = renderer.draw(frame);
  frame.surfaces.clear();
  const Image background = renderer.draw(frame);
  const auto covered = [&](const Image& image) {
    int count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) count += image.rgba[i + 1] != background.rgba[i + 1] ? 1 : 0;
    return count;
  };
  EXPECT_GT(covered(body), 4000);
  EXPECT_NEAR(covered(inverted), covered(body), 0.02 * covered(body));
}

// The message for a frame that cannot be drawn.
std::string refusal(const Frame& frame) {
  auto context = render::make_offscreen_context();
  try {
    Renderer(*context, 16, 16).draw(frame);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Robustness, BadSurfacesAreNamed) {
  const auto refused = [](auto change, const std::string& word) {
    Frame frame = full_frame();
    frame.surfaces[0].name = "left paw";
    change(frame);
    const std::string message = refusal(frame);
    EXPECT_NE(message.find("left paw"), std::string::npos) << message;
    EXPECT_NE(message.find(word), std::string::npos) << message;
  };
  refused([](Frame& f) { f.surfaces[0].positions[7] = std::numeric_limits<float>::quiet_NaN(); }, "vertex 2");
  refused([](Frame& f) { f.surfaces[0].positions[3] = std::numeric_limits<float>::infinity(); }, "finite");
  refused([](Frame& f) { f.surfaces[0].values[5] = std::numeric_limits<float>::quiet_NaN(); }, "value of vertex 5");
  refused([](Frame& f) { f.surfaces[0].values.pop_back(); }, "values");
  refused([](Frame& f) { f.surfaces[0].normals = {0, 0, 1}; }, "normals");
  refused([](Frame& f) { f.surfaces[0].positions.pop_back(); }, "three numbers");
  refused([](Frame& f) { f.surfaces[0].triangles[4] = 1000000; }, "1000000");
  refused([](Frame& f) { f.surfaces[0].edges.push_back(0); }, "edges");
  refused([](Frame& f) { f.scale.reset(); }, "colour scale");
}

TEST(Robustness, OtherBadFramesAreRefused) {
  const auto refused = [](auto change, const std::string& word) {
    Frame frame = full_frame();
    change(frame);
    const std::string message = refusal(frame);
    EXPECT_NE(message.find(word), std::string::npos) << message;
  };
  refused([](Frame& f) { f.camera.eye = f.camera.target; }, "camera");
  refused([](Frame& f) { f.ground->normal = {0, 0, 0}; }, "ground");
  refused([](Frame& f) { f.planes[0].point[0] = std::numeric_limits<float>::infinity(); }, "plane");
  refused([](Frame& f) { f.spheres[0].radius = -1; }, "-1");
  refused([](Frame& f) { f.arrows[0].to[2] = std::nanf(""); }, "arrow");
  refused([](Frame& f) { f.markers[0].at[2] = std::nanf(""); }, "marker");
  refused([](Frame& f) { f.labels[0].at[2] = std::nanf(""); }, "label \"bear\"");
  refused([](Frame& f) { f.strips[0].series[0].values.pop_back(); }, "kinetic");
  refused([](Frame& f) { f.scale->map = "jet"; }, "jet");
  refused([](Frame& f) { f.scale->high = std::nanf(""); }, "finite");
}

// A context that finds no functions.
class EmptyContext final : public render::Context {
 public:
  void make_current() override {}
  Getter getter() const override {
    return [](const char*) -> Procedure { return nullptr; };
  }
  int width() const override { return 1; }
  int height() const override { return 1; }
};

TEST(Robustness, ContextWithoutOpenGl) {
  EmptyContext context;
  EXPECT_THROW(Renderer(context, 16, 16), std::runtime_error);
}

// Resident memory in megabytes.
double resident() {
  std::ifstream status("/proc/self/statm");
  double total = 0, pages = 0;
  status >> total >> pages;
  return pages * 4096 / 1e6;
}

TEST(Robustness, MemoryDoesNotGrow) {
  Frame frame = full_frame();
  frame.surfaces = {shapes::bear(10)};
  frame.ghosts = {shapes::sphere({0.4F, 0, 0}, 0.5F, 6)};
  frame.spheres.clear();
  frame.planes.clear();
  frame.surfaces[0].round = true;
  frame.surfaces[0].values.assign(frame.surfaces[0].positions.size() / 3, 3);
  auto context = render::make_offscreen_context();
  Renderer renderer(*context, 64, 36);
  const auto draw = [&](int frames) {
    for (int i = 0; i < frames; ++i) {
      frame.surfaces[0].positions[0] += 1e-4F;
      frame.caption = "frame " + std::to_string(i);
      renderer.draw(frame);
    }
  };
  draw(50);
  const double before = resident();
  draw(2000);
  EXPECT_LT(resident() - before, 4);
}

}  // namespace
