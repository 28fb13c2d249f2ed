#include "app/trade/chart_layout.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double letter_width = 0.58;  // of its height, on average
constexpr double line_half = 3;        // pixels, of a line across

struct Rectangle {
  double left, below, right, above;
  bool meets(const Rectangle& other) const {
    return left < other.right && other.left < right && below < other.above && other.below < above;
  }
};

double along(const AxisRange& range, double value) {
  return std::log(value / range.low) / std::log(range.high / range.low);
}

class Placement {
 public:
  explicit Placement(const Chart& chart) : chart_(chart) {
    constexpr double half = 8;  // of a point
    for (const Line& line : chart.lines)
      for (const Dot& dot : line.dots) {
        const double x = pixel_of_seconds(chart, dot.seconds), y = pixel_of_error(chart, dot.error);
        taken_.push_back({x - half, y - half, x + half, y + half});
      }
  }

  // Fast and accurate at once is where no point is; else slow and inaccurate.
  void add_triangles() {
    const double decades = std::log10(chart_.seconds.high / chart_.seconds.low),
                 of_error = std::log10(chart_.error.high / chart_.error.low);
    const double width = std::min(0.16 * decades, 0.15 * of_error), wide = std::pow(10, width);
    const double bottom = std::max(chart_.floor, chart_.error.low) * std::pow(10, 0.06 * of_error);
    const SlopeTriangle below{1, chart_.seconds.low * std::pow(10, 0.04 * decades), bottom, wide, wide},
        above{1, chart_.seconds.high / (wide * std::pow(10, 0.16 * decades)),
              chart_.error.high / (wide * wide * std::pow(10, 0.1 * of_error)), wide, wide};
    const SlopeTriangle first = is_free(around(below)) ? below : above;
    for (const int order : {1, 2})
      out_.triangles.push_back({order, first.seconds, first.error, wide, std::pow(wide, order)});
    for (const SlopeTriangle& triangle : out_.triangles) {
      const double x = pixel_of_seconds(chart_, triangle.seconds) + 6,
                   y = pixel_of_error(chart_, triangle.error * triangle.high);
      put({x, y, "order " + std::to_string(triangle.order), false, black});
    }
    taken_.push_back(around(first));
  }

  // Beside the line that stands at this time.
  void name_time(double seconds, const std::string& name, const char* colour) {
    const double x = pixel_of_seconds(chart_, seconds);
    taken_.push_back({x - line_half, axes_below, x + line_half, axes_above});
    for (const double y : {axes_above - 24, axes_above - 70, axes_below + 80, axes_below + 30})
      for (const double side : {x + 6, x - 6 - width(name, true)})
        if (try_to_put({side, y, name, true, colour})) return;
    put({x + 6, axes_below + 40, name, true, colour});
  }
  // Above or below the line that lies at this error.
  void name_error(double error, double pixels_above, const std::string& name, const char* colour) {
    const double line = pixel_of_error(chart_, error), y = line + pixels_above,
                 right = axes_right - 8 - width(name, true);
    taken_.push_back({axes_left, line - line_half, axes_right, line + line_half});
    for (const double x : {right, axes_left + 8, right - 150, axes_left + 158})
      if (try_to_put({x, y, name, true, colour})) return;
    put({right, y, name, true, colour});
  }

  void label(const Dot& dot, const Ink& ink, bool large, bool needed) {
    if (dot.label.empty()) return;
    const double x = pixel_of_seconds(chart_, dot.seconds), y = pixel_of_error(chart_, dot.error);
    const double w = width(dot.label, large), up = large ? 34 : 22;
    for (const auto& [dx, dy] :
         {std::pair(14.0, 0.0), std::pair(-14 - w, 0.0), std::pair(-w / 2, up), std::pair(-w / 2, -up),
          std::pair(10.0, up), std::pair(10.0, -up), std::pair(-10 - w, -up), std::pair(-10 - w, up)})
      if (try_to_put({x + dx, y + dy, dot.label, large, ink.colour})) return;
    if (needed) put({std::clamp(x + 14, axes_left, axes_right - w), y, dot.label, large, ink.colour});
  }

  const ChartLayout& result() const { return out_; }

 private:
  static double width(const std::string& text, bool large) {
    return letter_width * (large ? large_letters : small_letters) * static_cast<double>(text.size());
  }
  static Rectangle box(const PlacedText& text) {
    const double half = (text.large ? large_letters : small_letters) / 2;
    return {text.x, text.y - half, text.x + width(text.text, text.large), text.y + half};
  }
  Rectangle around(const SlopeTriangle& t) const {
    return {pixel_of_seconds(chart_, t.seconds) - 4, pixel_of_error(chart_, t.error) - 4,
            std::max(pixel_of_seconds(chart_, t.seconds * t.wide), pixel_of_seconds(chart_, t.seconds) + 120),
            pixel_of_error(chart_, t.error * t.wide * t.wide) + 14};
  }
  bool is_free(const Rectangle& r) const {
    return r.left >= axes_left && r.right <= axes_right && r.below >= axes_below && r.above <= axes_above &&
           std::ranges::none_of(taken_, [&](const Rectangle& other) { return r.meets(other); });
  }
  bool try_to_put(const PlacedText& text) {
    if (!is_free(box(text))) return false;
    put(text);
    return true;
  }
  void put(const PlacedText& text) {
    taken_.push_back(box(text));
    out_.texts.push_back(text);
  }

  const Chart& chart_;
  std::vector<Rectangle> taken_;
  ChartLayout out_;
};

}  // namespace

double pixel_of_seconds(const Chart& chart, double seconds) {
  return axes_left + (axes_right - axes_left) * along(chart.seconds, seconds);
}

double pixel_of_error(const Chart& chart, double error) {
  return axes_below + (axes_above - axes_below) * along(chart.error, error);
}

ChartLayout lay_out(const Chart& chart) {
  Placement layer(chart);
  layer.name_time(1, "real time", black);
  if (chart.budget > 0) layer.name_time(chart.budget, "budget", blue);
  if (chart.target > 0) layer.name_error(chart.target, 20, "target", blue);
  if (chart.floor > 0) layer.name_error(chart.floor, -22, "below", black);
  for (auto line = chart.lines.rbegin(); line != chart.lines.rend(); ++line)
    if (line->title.empty())
      for (const Dot& dot : line->dots) layer.label(dot, line->ink, true, true);
  layer.add_triangles();
  const auto on_front = [&](const Dot& dot) {
    return std::ranges::any_of(chart.front, [&](const Dot& member) { return member.of == dot.of; });
  };
  for (const bool first : {true, false})
    for (const Line& line : chart.lines)
      for (const Dot& dot : line.dots)
        if (!line.title.empty() && on_front(dot) == first) layer.label(dot, line.ink, false, false);
  return layer.result();
}

}  // namespace app
