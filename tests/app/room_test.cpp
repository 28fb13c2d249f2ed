// Nothing that is written or plotted covers the bodies or each other, in small pictures as in large ones.
#include "render/room.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

#include "app/picture/picture.h"
#include "app/scene/scene_file.h"
#include "render/context.h"
#include "render/renderer.h"
#include "tests/app/scene_fixture.h"

namespace app {
namespace {

constexpr const char* hanging = R"(title = "A cantilever with all that a picture may have"
[time]
seconds = 1
[[body]]
name = "beam"
mesh = { box = [4, 1, 1], cells = [4, 1, 1] }
material.young = 1e9
pin = [{ group = "left" }]
[look]
colour = "stress"
energies = true
labels = true
)";

constexpr const char* drawing = R"(title = "A plane beam with all that a picture may have"
[time]
seconds = 1
[[body]]
name = "beam"
mesh = { rectangle = [4, 1], cells = [4, 1] }
material.young = 1e9
pin = [{ group = "left" }]
[look]
axes = true
scale_bar = true
colour = "stretch"
energies = true
)";

class Room : public SceneFile {};

render::Image drawn(const Document& document, int width, int height, bool words) {
  const sim::System system(document.scene);
  const Picture picture(system, document, width, height);
  Moment moment{.state = system.initial_state(), .energies = {{0, 1, 2, 3}, {0.5, 2, 1, 3}}};
  render::Frame frame = picture.frame(moment);
  frame.ground.reset();
  frame.look.background = render::Background::paper;
  if (!words) {
    frame.title = frame.caption = "";
    frame.strips.clear();
    frame.labels.clear();
    frame.look.axes = frame.look.scale_bar = frame.look.legend = false;
  }
  const auto context = render::make_offscreen_context();
  render::Renderer renderer(*context, width, height, 4);
  return renderer.draw(frame);
}

// How many pixels of the bodies are drawn over by words and plots.
int covered(const Document& document, int width, int height) {
  const render::Image body = drawn(document, width, height, false);
  const render::Image all = drawn(document, width, height, true);
  int count = 0, seen = 0;
  const auto apart = [](const std::uint8_t* a, const std::uint8_t* b) {
    return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) > 40;
  };
  const std::array<std::uint8_t, 3> white = {255, 255, 255};
  for (std::size_t i = 0; i + 3 < body.rgba.size(); i += 4) {
    if (!apart(body.rgba.data() + i, white.data())) continue;
    ++seen;
    count += apart(body.rgba.data() + i, all.rgba.data() + i);
  }
  EXPECT_GT(seen, width * height / 400);
  return count;
}

TEST_F(Room, NothingCoversTheBodies) {
  for (const char* scene : {hanging, drawing})
    for (const auto& [width, height] : {std::pair{320, 180}, {1920, 1080}})
      EXPECT_EQ(covered(load(scene), width, height), 0) << scene << width;
}

TEST_F(Room, IsSmallerTheMoreStandsAroundIt) {
  const render::Box bare = render::room_for({}, 1920, 1080);
  render::Contents full{
      .title = "title", .caption = "t = 1 s", .labels = true, .strips = 1, .legend = "von Mises stress"};
  full.look.axes = full.look.scale_bar = true;
  const render::Box room = render::room_for(full, 1920, 1080), small = render::room_for(full, 320, 180);
  EXPECT_LT(bare.left, room.left);
  EXPECT_LT(bare.top, room.top);
  EXPECT_GT(bare.right, room.right);
  EXPECT_GT(bare.bottom, room.bottom);
  for (const render::Box& box : {bare, room, small}) {
    EXPECT_GE(box.right - box.left, 1.0 / 3 - 1e-9);
    EXPECT_GE(box.bottom - box.top, 1.0 / 3 - 1e-9);
  }
}

}  // namespace
}  // namespace app
