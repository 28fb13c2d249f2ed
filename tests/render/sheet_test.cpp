// The sheet of a lecture: where its spots are, and that it can be read on a washed-out projector.
#include "render/sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/renderer.h"

namespace render {
namespace {

// Relative luminance of an sRGB colour [WCAG 2.1].
double luminance(const std::array<double, 3>& rgb) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(rgb[0]) + 0.7152 * linear(rgb[1]) + 0.0722 * linear(rgb[2]);
}

// Against paper, after both are blended 40 % towards white.
double washed_contrast(double r, double g, double b) {
  const auto washed = [](double c) { return 0.6 * c / 255 + 0.4; };
  return 1.05 / (luminance({washed(r), washed(g), washed(b)}) + 0.05);
}

TEST(Sheet, InksAreReadOnAWashedOutProjector) {
  for (const Ink ink : {Ink::black, Ink::blue, Ink::red, Ink::purple}) {
    const auto [r, g, b] = ink_colour(ink);
    EXPECT_GE(washed_contrast(r, g, b), 4.5) << r << " " << g << " " << b;
  }
}

TEST(Sheet, SpotsAndPixelsAreInverse) {
  for (const bool equal : {false, true})
    for (const bool axes : {false, true}) {
      Diagram d{.place = {0.1, 0.2, 0.6, 0.9}, .title = "t", .x = {-1, 3}, .y = {2, 9}, .equal = equal, .axes = axes};
      const Spot pixel = to_page(d, {0.5, 4}, 1280, 720), back = from_page(d, pixel, 1280, 720);
      EXPECT_NEAR(back[0], 0.5, 1e-12);
      EXPECT_NEAR(back[1], 4, 1e-12);
      EXPECT_GT(pixel[0], 128);
      EXPECT_LT(pixel[0], 768);
      if (!equal) continue;
      const Spot right = to_page(d, {1.5, 4}, 1280, 720), up = to_page(d, {0.5, 5}, 1280, 720);
      EXPECT_NEAR(right[0] - pixel[0], pixel[1] - up[1], 1e-9) << "the same scale along both";
    }
}

TEST(Sheet, NumbersComeInTheOrderOfReading) {
  Sheet sheet;
  sheet.blocks = {{"a",
                   {Line{"E", {"E", "1.0", "Pa"}}, Line{"words only", {}},
                    Matrix{"F", 2, {{"F11", "1", ""}, {"F12", "0", ""}}, "m"}}},
                  {"b", {Table{{"", "x"}, {{"row", {{"x1", "7", "m"}}}}, {}}}}};
  sheet.proof = {"sum", "0", "N"};
  const std::vector<Number> all = numbers_of(sheet);
  ASSERT_EQ(all.size(), 5U);
  EXPECT_EQ(all[0].name, "E");
  EXPECT_EQ(all[2].name, "F12");
  EXPECT_EQ(all[2].unit, "m") << "a matrix has one unit";
  EXPECT_EQ(all[3].text, "7");
  EXPECT_EQ(all[4].name, "sum");
}

Frame lecture_frame() {
  Frame frame;
  frame.camera.orthographic = true;
  frame.look.background = Background::paper;
  frame.look.lecture = true;
  frame.title = "HHHH";
  frame.sheet.emplace();
  return frame;
}

// First and last row of a rectangle with ink in it.
std::array<int, 2> inked_rows(const Image& image, int left, int right, int top, int bottom) {
  std::array<int, 2> rows = {bottom, top};
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) {
      const std::uint8_t* pixel = image.rgba.data() + 4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
      if (pixel[0] > 128) continue;
      rows = {std::min(rows[0], y), std::max(rows[1], y)};
    }
  return rows;
}

// DejaVu's capitals are 0.729 em high: an em of 1/24 of 720 pixels makes 22 rows.
TEST(Sheet, LettersAreLargeAndLinesThick) {
  const auto context = make_offscreen_context();
  Renderer renderer(*context, 1280, 720);
  Frame frame = lecture_frame();
  frame.sheet->diagrams.push_back({.place = {0.1, 0.3, 0.5, 0.8}, .strokes = {{{{0, 0.5}, {1, 0.5}}}}});
  frame.sheet->blocks = {{"", {Line{"H", {"h", "H", ""}}}}};
  const Image image = renderer.draw(frame);
  const std::array<int, 2> title = inked_rows(image, 0, 200, 0, 60), line = inked_rows(image, 300, 400, 250, 550),
                           letter = inked_rows(image, 845, 900, 60, 110);
  EXPECT_GE(title[1] - title[0] + 1, static_cast<int>(0.729 * 720 / 24));
  EXPECT_GE(letter[1] - letter[0] + 1, static_cast<int>(0.729 * 720 / 28));
  EXPECT_GE(line[1] - line[0] + 1, 3);
}

// The pixel at (x, y), 0 to 255.
std::array<int, 3> pixel_of(const Image& image, int x, int y) {
  const std::uint8_t* p = image.rgba.data() + 4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
  return {p[0], p[1], p[2]};
}

// A curve of any ink over a dark patch: on both sides it has white beside it, to which its contrast is that to paper.
TEST(Sheet, CurvesOverColoursHaveAWhiteBorder) {
  const auto context = make_offscreen_context();
  Renderer renderer(*context, 1280, 720);
  for (const Ink ink : {Ink::black, Ink::blue, Ink::red, Ink::purple}) {
    Frame frame = lecture_frame();
    Diagram d{.place = {0.1, 0.3, 0.5, 0.8}};
    d.patches.push_back({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {120, 165, 240}});
    d.strokes.push_back({{{0, 0.5}, {1, 0.5}}, ink});
    frame.sheet->diagrams.push_back(d);
    const Image image = renderer.draw(frame);
    const Spot middle = to_page(d, {0.5, 0.5}, 1280, 720);
    const int x = static_cast<int>(middle[0]), y = static_cast<int>(middle[1]);
    EXPECT_EQ(pixel_of(image, x, y), ink_colour(ink));
    for (const int way : {-1, 1}) {
      bool white = false;
      for (int k = 1; k <= 5; ++k) white = white || pixel_of(image, x, y + way * k) == std::array{255, 255, 255};
      EXPECT_TRUE(white) << "ink " << static_cast<int>(ink);
      EXPECT_EQ(pixel_of(image, x, y + way * 12), (std::array{120, 165, 240})) << "the patch goes on";
    }
  }
}

// Whatever a sheet holds, its column ends above the proof, its drawings at their place, its words inside of it.
TEST(Sheet, WhatDoesNotFitIsLeftOut) {
  const auto context = make_offscreen_context();
  for (const auto& [width, height] : {std::array{1280, 720}, std::array{640, 360}, std::array{320, 180}}) {
    Renderer renderer(*context, width, height);
    Frame frame = lecture_frame();
    Block block;
    for (int k = 0; k < 40; ++k) block.items.push_back(Line{"label", {"n" + std::to_string(k), "1.000", "m"}});
    frame.sheet->blocks = {block};
    Diagram d{.place = {0.1, 0.3, 0.5, 0.8}};
    d.strokes.push_back({{{-3, 0.5}, {3, 0.5}}});
    d.strokes.push_back({{{0.5, -3}, {0.5, 3}}});
    d.words.push_back({{1, 0.2}, "a word at the edge"});
    frame.sheet->diagrams = {d};
    const Image image = renderer.draw(frame);
    const auto at = [](double share, int size) { return static_cast<int>(share * size); };
    const std::array<int, 2> column = inked_rows(image, at(0.66, width), width, at(0.08, height), height);
    EXPECT_LT(column[1], at(0.93, height));
    EXPECT_GT(column[1], at(0.80, height)) << "and the column is full";
    const std::array<int, 2> drawing = inked_rows(image, at(0.1, width), at(0.5, width), at(0.08, height), height);
    EXPECT_GE(drawing[0], at(0.3, height) - 1);
    EXPECT_LE(drawing[1], at(0.82, height));
    const std::array<int, 2> right = inked_rows(image, at(0.52, width), at(0.65, width), 0, height);
    EXPECT_GT(right[0], right[1]) << "nothing beside the diagram";
  }
}

// Digits have one width, and room is kept for a sign: brackets and columns stay where they are.
TEST(Sheet, DigitsDoNotDance) {
  const auto context = make_offscreen_context();
  Renderer renderer(*context, 640, 360);
  const auto left_edge = [&](const std::string& number) {
    Frame frame = lecture_frame();
    frame.sheet->blocks = {
        {"", {Matrix{"", 2, {{"a", number, ""}, {"b", "1.00", ""}, {"c", "2.00", ""}, {"d", "3.00", ""}}}}}};
    const Image image = renderer.draw(frame);
    for (int x = 400; x < 640; ++x)
      if (inked_rows(image, x, x + 1, 30, 90)[1] > 30) return x;
    return 640;
  };
  EXPECT_LT(left_edge("1.23"), 600);
  EXPECT_EQ(left_edge("1.23"), left_edge("-9.87"));
}

// A page that is narrower than 16:9 has smaller letters: what is beside another thing stays beside it.
TEST(Sheet, NarrowPagesAreThePageMadeSmaller) {
  const Diagram d{.place = {0.1, 0.2, 0.6, 0.9}, .title = "t", .axes = true};
  const Box wide = area_of(d, 1280, 720), narrow = area_of(d, 640, 720);
  EXPECT_NEAR(narrow.left, wide.left / 2, 1e-9);
  EXPECT_NEAR(narrow.right, wide.right / 2, 1e-9);
  EXPECT_EQ(measure_of(1280, 720), 720);
  EXPECT_EQ(measure_of(640, 720), 360);
}

// The usual look comes back after a lecture's, to the byte.
TEST(Sheet, OneRendererDrawsLecturesAndOthersInTurn) {
  const auto context = make_offscreen_context();
  Renderer renderer(*context, 320, 180);
  Frame usual = lecture_frame();
  usual.look.lecture = false;
  usual.sheet.reset();
  const Image before = renderer.draw(usual);
  const Image lecture = renderer.draw(lecture_frame());
  EXPECT_NE(lecture.rgba, before.rgba);
  EXPECT_EQ(renderer.draw(usual).rgba, before.rgba);
}

}  // namespace
}  // namespace render
