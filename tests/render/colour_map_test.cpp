#include "render/colour_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace {

// CIE 1976 lightness of an sRGB colour, 0 to 100.
double lightness(const render::Colour& colour) {
  const Eigen::Vector3f linear = render::to_linear(colour);
  const double y = 0.2126 * linear.x() + 0.7152 * linear.y() + 0.0722 * linear.z();
  return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

void expect_colour(const render::Colour& colour, int red, int green, int blue) {
  EXPECT_NEAR(colour[0] * 255, red, 0.51);
  EXPECT_NEAR(colour[1] * 255, green, 0.51);
  EXPECT_NEAR(colour[2] * 255, blue, 0.51);
}

TEST(ColourMap, EndsAndMiddleAreThePublishedColours) {
  expect_colour(render::colour_at("viridis", 0), 68, 1, 84);
  expect_colour(render::colour_at("viridis", 0.5F), 33, 145, 140);
  expect_colour(render::colour_at("viridis", 1), 253, 231, 37);
  expect_colour(render::colour_at("cividis", 0), 0, 32, 77);
  expect_colour(render::colour_at("cividis", 1), 255, 234, 70);
  expect_colour(render::colour_at("magma", 1), 252, 253, 191);
  expect_colour(render::colour_at("plasma", 0), 13, 8, 135);
  expect_colour(render::colour_at("blue-red", 0.5F), 247, 247, 247);
}

TEST(ColourMap, LightnessRisesEvenly) {
  for (const char* map : {"viridis", "cividis", "magma", "plasma"}) {
    const double low = lightness(render::colour_at(map, 0)), high = lightness(render::colour_at(map, 1));
    double before = low;
    for (int i = 1; i <= 200; ++i) {
      const double t = i / 200.0, now = lightness(render::colour_at(map, static_cast<float>(t)));
      EXPECT_GT(now, before) << map << " at " << t;
      EXPECT_NEAR(now, low + t * (high - low), 6) << map << " at " << t;
      before = now;
    }
  }
}

TEST(ColourMap, DivergingMapIsLightestInTheMiddle) {
  for (int i = 0; i < 100; ++i) {
    const float t = 0.5F * static_cast<float>(i) / 100, next = t + 0.005F;
    EXPECT_LT(lightness(render::colour_at("blue-red", t)), lightness(render::colour_at("blue-red", next)));
    EXPECT_LT(lightness(render::colour_at("blue-red", 1 - t)), lightness(render::colour_at("blue-red", 1 - next)));
  }
}

TEST(ColourMap, ValuesOutsideTakeTheEnds) {
  EXPECT_EQ(render::colour_at("magma", -3), render::colour_at("magma", 0));
  EXPECT_EQ(render::colour_at("magma", 7), render::colour_at("magma", 1));
}

TEST(ColourMap, UnknownNameIsRefusedWithTheKnownOnes) {
  try {
    render::colour_at("rainbow", 0.5F);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("rainbow"), std::string::npos);
    for (const std::string_view known : render::colour_map_names()) {
      const std::string name(known);
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << name;
    }
  }
}

TEST(Srgb, KnownPairsAndRoundTrip) {
  EXPECT_NEAR(render::to_linear(0.5F), 0.2140411, 1e-6);
  EXPECT_NEAR(render::to_srgb(0.18F), 0.4613561, 1e-6);
  EXPECT_NEAR(render::to_linear(0.04045F), 0.0031308, 1e-7);
  for (int i = 0; i < 256; ++i) {
    EXPECT_NEAR(render::to_srgb(render::to_linear(static_cast<float>(i) / 255)) * 255, i, 1e-3);
  }
}

}  // namespace
