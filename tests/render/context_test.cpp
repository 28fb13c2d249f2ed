// What draws without a window: every kind that was built gives the same picture.
#include "render/context.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <thread>

#include "render/compare.h"
#include "render/gl.h"
#include "render/renderer.h"
#include "tests/render/shapes.h"

namespace {

using render::Image;
using render::OffscreenKind;

Image picture_by(const OffscreenKind& kind) {
  render::Frame frame;
  frame.ground = render::Ground{{0, -0.93F, 0}, {0, 1, 0}};
  frame.camera.eye = {1.6F, 0.7F, 4.2F};
  frame.surfaces.push_back(shapes::bear(28));
  frame.title = "The same picture";
  const auto context = kind.make();
  return render::Renderer(*context, 320, 180).draw(frame);
}

TEST(Contexts, EveryKindDrawsTheSamePicture) {
  const Image first = picture_by(render::offscreen_kinds().front());
  EXPECT_FALSE(std::ranges::all_of(first.rgba, [&](std::uint8_t byte) { return byte == first.rgba[0]; }));
  for (const OffscreenKind& kind : render::offscreen_kinds()) {
    EXPECT_LE(render::compare(picture_by(kind), first, 8).share, 0.01) << kind.name;
  }
}

TEST(Contexts, EveryKindNamesItsDriver) {
  for (const OffscreenKind& kind : render::offscreen_kinds()) {
    EXPECT_NE(render::driver_of(*kind.make()), "") << kind.name;
  }
}

// Two of a kind in one thread, and one that is handed to another thread.
TEST(Contexts, OfOneKindLiveBesideEachOther) {
  for (const OffscreenKind& kind : render::offscreen_kinds()) {
    const auto one = kind.make(), other = kind.make();
    GladGLContext gl = render::load_gl(*one);
    gl.ClearColor(0.25F, 0, 0, 1);
    render::load_gl(*other).ClearColor(0.75F, 0, 0, 1);
    one->make_current();
    float colour[4] = {};
    gl.GetFloatv(GL_COLOR_CLEAR_VALUE, colour);
    EXPECT_EQ(colour[0], 0.25F) << kind.name;
  }
  for (const OffscreenKind& kind : render::offscreen_kinds()) {
    Image here = picture_by(kind), there;
    std::thread([&] { there = picture_by(kind); }).join();
    EXPECT_EQ(here.rgba, there.rgba) << kind.name;
  }
}

TEST(Contexts, AnUnknownNameIsToldTheKnownOnes) {
  EXPECT_NE(render::make_offscreen_context(), nullptr);
  try {
    render::make_offscreen_context("vulkan");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("vulkan"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find(render::offscreen_kinds().front().name), std::string::npos);
  }
}

}  // namespace
