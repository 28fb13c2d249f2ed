// Pictures, by the numbers of their pixels.
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

#include "render/light.h"
#include "render/view.h"
#include "tests/render/shapes.h"

namespace {

using render::Frame;
using render::Image;
using render::Renderer;

std::array<int, 3> pixel(const Image& image, int x, int y) {
  const std::size_t i = 4 * (static_cast<std::size_t>(y) * image.width + x);
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
}

int sum(const std::array<int, 3>& colour) {
  return colour[0] + colour[1] + colour[2];
}

// A renderer with its context.
struct Studio {
  Studio(int width, int height, int samples = 4) : renderer(*context, width, height, samples) {}
  Image draw(const Frame& frame) { return renderer.draw(frame); }
  std::unique_ptr<render::Context> context = render::make_offscreen_context();
  Renderer renderer;
};

// White paper, no light tricks: what is not white is a body.
Frame on_paper() {
  Frame frame;
  frame.look.background = render::Background::paper;
  frame.look.shadow = frame.look.occlusion = false;
  return frame;
}

// A flat square [-1, 1]^2 of one colour, seen by a parallel camera of height 4.
Frame flat_square(const render::Colour& colour) {
  Frame frame = on_paper();
  frame.camera.orthographic = true;
  frame.camera.height = 4;
  frame.surfaces.push_back(shapes::lattice(4, 4, [](float u, float v) {
    return render::Point{2 * u - 1, 2 * v - 1, 0};
  }));
  frame.surfaces[0].flat = true;
  frame.surfaces[0].colour = colour;
  frame.surfaces[0].outline.clear();
  return frame;
}

TEST(Renderer, SphereIsSeenWherePerspectivePutsIt) {
  Frame frame = on_paper();
  frame.camera.eye = {0, 0, 6};
  frame.camera.field_of_view = 30;
  frame.surfaces.push_back(shapes::sphere({0.4F, -0.2F, 0}, 0.7F, 80));
  const int width = 640, height = 360;
  const Image image = Studio(width, height).draw(frame);
  // The sphere's shadow on the screen is a conic; along the vertical plane through the eye and the axis x = const it
  // reaches from angle a - b to a + b, where a is the centre's and sin b = r / distance.
  const double focal = height / 2.0 / std::tan(15 * M_PI / 180);
  const double distance = std::hypot(0.4, 0.2, 6.0), half = std::asin(0.7 / distance);
  const double across = std::hypot(0.4, 0.2), centre = std::atan(across / 6);
  // Along the line from the middle of the picture through the sphere's centre:
  const double dx = 0.4 / across, dy = 0.2 / across;
  for (const double angle : {centre - half, centre + half}) {
    const double reach = focal * std::tan(angle);
    const auto white = [&](double r) {
      const int x = static_cast<int>(std::floor(width / 2.0 + r * dx));
      const int y = static_cast<int>(std::floor(height / 2.0 + r * dy));
      return pixel(image, x, y) == std::array<int, 3>{255, 255, 255};
    };
    const double outwards = angle > centre ? 1 : -1;
    EXPECT_TRUE(white(reach + 1.5 * outwards)) << angle;
    EXPECT_FALSE(white(reach - 1.5 * outwards)) << angle;
  }
}

TEST(Renderer, SphereIsLitFromTheUpperLeft) {
  Frame frame = on_paper();
  frame.surfaces.push_back(shapes::sphere({0, 0, 0}, 1));
  const Image image = Studio(400, 400).draw(frame);
  const int r = static_cast<int>(200 * std::tan(std::asin(0.2)) / std::tan(17.5 * M_PI / 180) * 0.55);
  EXPECT_GT(sum(pixel(image, 200 - r, 200 - r)), 1.5 * sum(pixel(image, 200 + r, 200 + r)));
}

TEST(Renderer, FlatColoursAreExact) {
  Studio studio(200, 100);
  for (const float level : {0.0F, 0.02F, 0.2F, 0.5F, 0.73F, 1.0F}) {
    const Image image = studio.draw(flat_square({level, 0.5F, 1 - level}));
    const std::array<int, 3> middle = pixel(image, 103, 52);
    EXPECT_NEAR(middle[0], 255 * level, 1);
    EXPECT_NEAR(middle[1], 127.5, 1);
    EXPECT_NEAR(middle[2], 255 * (1 - level), 1);
    EXPECT_EQ(pixel(image, 20, 50), (std::array<int, 3>{255, 255, 255}));
  }
}

TEST(Renderer, ValuesTakeTheColoursOfTheScale) {
  Frame frame = flat_square({0, 0, 0});
  frame.scale = render::ColourScale{"viridis", 10, 30, "stress", "Pa"};
  frame.look.legend = false;
  Studio studio(100, 100);
  const auto middle_for = [&](float value) {
    frame.surfaces[0].values.assign(frame.surfaces[0].positions.size() / 3, value);
    return pixel(studio.draw(frame), 50, 50);
  };
  const auto expect_near = [](const std::array<int, 3>& colour, int r, int g, int b) {
    EXPECT_NEAR(colour[0], r, 1);
    EXPECT_NEAR(colour[1], g, 1);
    EXPECT_NEAR(colour[2], b, 1);
  };
  expect_near(middle_for(10), 68, 1, 84);
  expect_near(middle_for(20), 33, 145, 140);
  expect_near(middle_for(30), 253, 231, 37);
  expect_near(middle_for(99), 253, 231, 37);
  frame.scale->high = frame.scale->low;  // no extent: the middle
  expect_near(middle_for(99), 33, 145, 140);
}

TEST(Renderer, EdgesAreMixedInLinearLight) {
  // The upper edge of a black square runs through the middle of a row of pixels.
  Frame frame = flat_square({0, 0, 0});
  const auto middle_row = [&](int samples) {
    frame.camera.height = 4;
    frame.camera.eye = {0, 1.02F, 5};
    frame.camera.target = {0, 1.02F, 0};
    return pixel(Studio(100, 100, samples).draw(frame), 50, 50)[0];  // rows are 0.04 high
  };
  EXPECT_NEAR(middle_row(4), 255 * std::pow(0.5, 1 / 2.2), 8);
  const int single = middle_row(1);
  EXPECT_TRUE(single == 0 || single == 255) << single;
}

TEST(Renderer, ShadowFallsAlongTheLight) {
  Frame frame;
  frame.camera.eye = {0, 4, 7};
  frame.ground = render::Ground{};
  frame.surfaces.push_back(shapes::sphere({0, 1.2F, 0}, 0.5F));
  const int width = 480, height = 270;
  const render::View view = render::make_view(frame.camera, 16.0F / 9, render::bounds_of(frame));
  const Eigen::Vector3f key = render::light_of(frame, view).key;
  const Eigen::Vector3f shaded = Eigen::Vector3f(0, 1.2F, 0) - key * (1.2F / key.y());
  Studio studio(width, height);
  const Image with = studio.draw(frame);
  frame.look.shadow = false;
  const Image without = studio.draw(frame);
  const auto darkening = [&](const Eigen::Vector3f& point) {
    const Eigen::Vector3f at = view.to_window(point, width, height);
    const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    return static_cast<double>(sum(pixel(with, x, y))) / sum(pixel(without, x, y));
  };
  EXPECT_LT(darkening(shaded), 0.75);
  EXPECT_DOUBLE_EQ(darkening(shaded + Eigen::Vector3f(1.2F, 0, 0)), 1);
  EXPECT_DOUBLE_EQ(darkening(shaded - Eigen::Vector3f(1.2F, 0, 0)), 1);
  // Soft: between full shadow and full light lie several levels.
  std::vector<double> levels;
  for (int i = 0; i <= 40; ++i)
    levels.push_back(darkening(shaded + Eigen::Vector3f(0.02F * static_cast<float>(i), 0, 0)));
  EXPECT_GT(std::count_if(levels.begin(), levels.end(), [](double level) { return level > 0.72 && level < 0.97; }), 4);
}

TEST(Renderer, LitSurfacesDoNotShadeThemselves) {
  // A large plate that faces the light: shadow acne would speckle it.
  Frame frame;
  frame.camera.eye = {0, 3, 6};
  frame.look.occlusion = false;
  frame.surfaces.push_back(shapes::lattice(30, 30, [](float u, float v) {
    return render::Point{4 * u - 2, 0, 2 - 4 * v};
  }));
  Studio studio(400, 300);
  const Image with = studio.draw(frame);
  frame.look.shadow = false;
  const Image without = studio.draw(frame);
  for (std::size_t i = 0; i < with.rgba.size(); ++i) ASSERT_NEAR(with.rgba[i], without.rgba[i], 2);
}

TEST(Renderer, CreasesAreDarker) {
  // Two walls that meet in a corner, seen from the open side.
  Frame frame;
  frame.camera.eye = {0, 2, 6};
  frame.look.shadow = false;
  frame.surfaces.push_back(shapes::lattice(8, 8, [](float u, float v) {
    return render::Point{4 * u - 2, 0, 2 - 2 * v};
  }));
  frame.surfaces.push_back(shapes::lattice(8, 8, [](float u, float v) { return render::Point{4 * u - 2, 2 * v, 0}; }));
  Studio studio(400, 300);
  const Image with = studio.draw(frame);
  frame.look.occlusion = false;
  const Image without = studio.draw(frame);
  const render::View view = render::make_view(frame.camera, 4.0F / 3, render::bounds_of(frame));
  const auto darkening = [&](const Eigen::Vector3f& point) {
    const Eigen::Vector3f at = view.to_window(point, 400, 300);
    const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    return static_cast<double>(sum(pixel(with, x, y))) / sum(pixel(without, x, y));
  };
  EXPECT_LT(darkening({0, 0.05F, 0}), 0.93);
  EXPECT_LT(darkening({0, 0, 0.08F}), 0.93);
  EXPECT_NEAR(darkening({0, 1.2F, 0}), 1, 0.01);
}

TEST(Renderer, WireframeLiesOnTheSurface) {
  Frame frame = flat_square({0.8F, 0.8F, 0.8F});
  Studio studio(400, 400);
  const Image without = studio.draw(frame);
  frame.look.wireframe = true;
  const Image with = studio.draw(frame);
  // Lattice lines every 50 pixels from 100 to 300; cells between them keep their colour.
  for (const int line : {150, 200, 250}) {
    const int darkest = std::min(sum(pixel(with, line - 1, 175)), sum(pixel(with, line, 175)));
    EXPECT_LT(darkest, 0.9 * sum(pixel(without, line, 175))) << line;
    EXPECT_EQ(pixel(with, line + 20, 175), pixel(without, line + 20, 175));
  }

  // On a lit body as well, without gaps: the equator's lines are seen all along.
  frame = on_paper();
  frame.surfaces.push_back(shapes::sphere({0, 0, 0}, 1, 20));
  frame.camera.orthographic = true;
  frame.camera.height = 2.5F;
  const Image plain = studio.draw(frame);
  frame.look.wireframe = true;
  const Image wired = studio.draw(frame);
  int seen = 0;
  for (int x = 60; x < 340; ++x) {
    int darkest = 1000;
    for (const int y : {198, 199, 200, 201})
      darkest = std::min(darkest, sum(pixel(wired, x, y)) - sum(pixel(plain, x, y)));
    seen += darkest < -20 ? 1 : 0;
  }
  EXPECT_GT(seen, 275);
}

TEST(Renderer, TextIsWhereItBelongs) {
  Frame frame = on_paper();
  for (const auto& [width, height] : {std::pair{320, 180}, {1920, 1080}}) {
    Studio studio(width, height);
    const auto ink = [&](const Image& image, double x0, double y0, double x1, double y1) {
      int dark = 0, left = width, right = 0, top = height, bottom = 0;
      for (int y = static_cast<int>(y0 * height); y < static_cast<int>(y1 * height); ++y) {
        for (int x = static_cast<int>(x0 * width); x < static_cast<int>(x1 * width); ++x) {
          if (sum(pixel(image, x, y)) >= 300) continue;
          ++dark;
          left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
        }
      }
      return std::array<int, 3>{dark, right - left, bottom - top};
    };
    frame.caption = "";
    EXPECT_EQ(ink(studio.draw(frame), 0, 0, 1, 1)[0], 0);
    frame.caption = "H";
    const Image image = studio.draw(frame);
    const std::array<int, 3> letter = ink(image, 0, 0.8, 0.3, 1);
    EXPECT_EQ(letter[0], ink(image, 0, 0, 1, 1)[0]);  // nowhere else
    // A capital is legible from 7 pixels on, and stays in proportion.
    EXPECT_GE(letter[2], std::max(6, height / 60)) << height;
    EXPECT_LE(letter[2], std::max(12, height / 30)) << height;
  }
}

TEST(Renderer, LegendNeedsValues) {
  Frame frame = flat_square({0.5F, 0.5F, 0.5F});
  frame.scale = render::ColourScale{"viridis", 0, 1, "stress", "Pa"};
  Studio studio(640, 360);
  const Image without = studio.draw(frame);
  frame.surfaces[0].values.assign(25, 0.5F);
  const Image with = studio.draw(frame);
  int yellow = 0, violet = 0;
  for (int y = 0; y < 360; ++y) {
    for (int x = 500; x < 640; ++x) {
      EXPECT_EQ(sum(pixel(without, x, y)), 765);
      const std::array<int, 3> c = pixel(with, x, y);
      yellow += c[0] > 200 && c[1] > 200 && c[2] < 90 ? 1 : 0;
      violet += c[0] < 90 && c[1] < 40 && c[2] > 70 ? 1 : 0;
    }
  }
  EXPECT_GT(yellow, 50);
  EXPECT_GT(violet, 50);
}

}  // namespace
