// Where the parts of a chart lie in its picture, so that nothing is written over anything else.
#pragma once

#include <string>
#include <vector>

#include "app/trade/chart.h"

namespace app {

// Of the picture, and of its axes in it; pixels, from the lower left.
inline constexpr double chart_width = 1280, chart_height = 720;
inline constexpr double axes_left = 100, axes_right = 1165, axes_below = 160, axes_above = 545;
// Heights of letters: of axes and names, of what is beside points. At a quarter of the size they are still legible.
inline constexpr double large_letters = 30, small_letters = 23;

struct PlacedText {
  double x = 0, y = 0;  // pixels, the middle of its left end
  std::string text;
  bool large = false;
  std::string colour = black;
};

// From a point to its label, where that stands away from it; pixels.
struct Leader {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  std::string colour = black;
};

// A triangle whose longest side has the slope of an order: error = C time^-order.
struct SlopeTriangle {
  int order = 1;
  double seconds = 0, error = 0;  // at its right angle
  double wide = 1, high = 1;      // factors to its other corners
};

struct ChartLayout {
  std::vector<PlacedText> texts;
  std::vector<Leader> leaders;
  std::vector<SlopeTriangle> triangles;
};

// Names first, then the steps of points on the front, then those of others. Each beside its point where there is room;
// a step is left out where there is none, or where the same step stands near it.
ChartLayout lay_out(const Chart& chart);

// Pixels of a place in the chart.
double pixel_of_seconds(const Chart& chart, double seconds);
double pixel_of_error(const Chart& chart, double error);

// How wide a text is drawn, about; as much of its beginning as is not wider than given, with "..." where it is cut.
double text_width(std::string_view text, bool large);
std::string fitting(const std::string& text, bool large, double width);

}  // namespace app
