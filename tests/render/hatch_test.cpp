// Planes that are seen edge-on.
#include "render/hatch.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/context.h"
#include "render/renderer.h"

namespace {

constexpr int size = 200;

// A floor at y = -1, out of which (0, 1, 0) points, in a picture of 4 m.
render::Frame floor_frame() {
  render::Frame frame;
  frame.look.background = render::Background::paper;
  frame.camera.orthographic = true;
  frame.camera.height = 4;
  frame.planes = {{{0, -1, 0}, {0, 1, 0}}};
  return frame;
}

// Shares of dark pixels by row.
std::vector<double> darkness(const render::Frame& frame) {
  const auto context = render::make_offscreen_context();
  const render::Image image = render::Renderer(*context, size, size, 1).draw(frame);
  std::vector<double> rows;
  for (int y = 0; y < size; ++y) {
    int dark = 0;
    for (int x = 0; x < size; ++x) dark += image.rgba[4 * (static_cast<std::size_t>(y) * size + x)] < 180;
    rows.push_back(double(dark) / size);
  }
  return rows;
}

TEST(Hatch, APlaneIsALineWithItsSolidSideHatched) {
  const std::vector<double> rows = darkness(floor_frame());
  const int line = size / 2 + size / 4;
  EXPECT_GT(std::max({rows[line - 1], rows[line], rows[line + 1]}), 0.95);
  for (int y = 0; y < line - 3; ++y) EXPECT_EQ(rows[y], 0) << y;
  for (int y = line + 3; y < line + 6; ++y) {
    EXPECT_GT(rows[y], 0.05) << y;
    EXPECT_LT(rows[y], 0.5) << y;
  }
  for (int y = line + 12; y < size; ++y) EXPECT_EQ(rows[y], 0) << y;
}

TEST(Hatch, NoneWherePlanesAreSeenFromAside) {
  render::Frame tilted = floor_frame();
  tilted.camera.eye = {0, 3, 4};
  const std::vector<double> rows = darkness(tilted);
  EXPECT_LT(*std::max_element(rows.begin(), rows.end()), 0.05);
}

}  // namespace
