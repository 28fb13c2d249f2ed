#include "app/trade/chart_layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {
namespace {

constexpr double line_half = 3;  // pixels, of a line across

struct Rectangle {
  double left, below, right, above;
  bool meets(const Rectangle& other) const {
    return left < other.right && other.left < right && below < other.above && other.below < above;
  }
  bool in_axes() const {
    return left >= axes_left && right <= axes_right && below >= axes_below && above <= axes_above;
  }
  bool is_free_of(const std::vector<Rectangle>& others) const {
    return std::ranges::none_of(others, [&](const Rectangle& other) { return meets(other); });
  }
};

double along(const AxisRange& range, double value) {
  return std::log(value / range.low) / std::log(range.high / range.low);
}

Rectangle box(const PlacedText& text) {
  const double half = (text.large ? large_letters : small_letters) / 2;
  return {text.x, text.y - half, text.x + text_width(text.text, text.large), text.y + half};
}

class Placement {
 public:
  explicit Placement(const Chart& chart) : chart_(chart) {
    for (const Line& line : chart.lines)
      for (std::size_t k = 0; k < line.dots.size(); ++k) {
        const Place at = place(line.dots[k]);
        const double half = 10 * line.size;
        taken_.push_back({at.x - half, at.y - half, at.x + half, at.y + half});
        if (!line.dots[k].label.empty()) steps_.emplace_back(at, line.dots[k].label);
        if (line.joined && k > 0) take_segment(place(line.dots[k - 1]), at);
      }
    for (std::size_t k = 1; k < chart.front.size(); ++k) take_segment(place(chart.front[k - 1]), place(chart.front[k]));
  }

  // Beside the line that stands at this time.
  void name_time(double seconds, const std::string& name, const char* colour) {
    const double x = pixel_of_seconds(chart_, seconds), right = x + 6, left = x - 6 - text_width(name, true);
    lines_.push_back({x - line_half, axes_below, x + line_half, axes_above});
    std::vector<PlacedText> places;
    for (const double y : {axes_above - 24, axes_above - 60, axes_below + 60, axes_below + 24})
      for (const double side : {right, left}) places.push_back({side, y, name, true, colour});
    put_first_free(places);
  }
  // Above or below the line that lies at this error.
  void name_error(double error, double pixels_above, const std::string& name, const char* colour) {
    const double line = pixel_of_error(chart_, error), right = axes_right - 8 - text_width(name, true);
    lines_.push_back({axes_left, line - line_half, axes_right, line + line_half});
    std::vector<PlacedText> places;
    for (const double x : {right, axes_left + 8, right - 150, axes_left + 158})
      places.push_back({x, line + pixels_above, name, true, colour});
    put_first_free(places);
  }

  // The name of a point, which is never left out: around it, the nearer the better.
  void name(const Dot& dot, const Ink& ink) {
    constexpr double nearest = 26, farther = 18, beside = 60;  // pixels
    const Place at = place(dot);
    const double w = text_width(dot.label, true);
    for (double away = nearest; away < axes_right - axes_left; away += farther)
      for (int k = 0; k < 12; ++k) {
        const double angle = 2 * std::numbers::pi * k / 12, x = at.x + away * std::cos(angle);
        // Its near end is so far away, or its middle, where it stands above or below.
        const double left = x - w * (1 - std::cos(angle)) / 2;
        const PlacedText text{left, at.y + away * std::sin(angle), dot.label, true, ink.dark};
        if (!is_free(text, away < 2 * beside)) continue;
        put(text);
        if (away > beside) lead(at, text);
        return;
      }
    put({std::clamp(at.x, axes_left, axes_right - w), at.y, dot.label, true, ink.dark});
  }

  // The step of a point, where there is room and the same does not stand near.
  void label(const Dot& dot, const Ink& ink) {
    const Place at = place(dot);
    if (dot.label.empty() || stands_near(dot.label, at)) return;
    const double w = text_width(dot.label, false);
    for (const bool off_lines : {true, false})
      for (const auto& [beside, up] : {std::pair(18.0, 26.0), std::pair(36.0, 44.0)})
        for (const auto& [dx, dy] :
             {std::pair(beside, 0.0), std::pair(-beside - w, 0.0), std::pair(-w / 2, up), std::pair(-w / 2, -up),
              std::pair(beside, up), std::pair(beside, -up), std::pair(-beside - w, up), std::pair(-beside - w, -up)}) {
          const PlacedText text{at.x + dx, at.y + dy, dot.label, false, ink.dark};
          if (is_free(text, off_lines) && is_nearest(text, at)) return put(text);
        }
  }

  // Two triangles at one right angle: at the place nearest to what is slow and inaccurate, where no point should be.
  void add_triangles() {
    constexpr double names = 92, letters = 26;         // pixels: beside them, from one name to the next
    constexpr double first_order = 44, at_most = 120;  // pixels: height, width
    const double error_decades = std::log10(chart_.error.high / chart_.error.low),
                 decades = std::log10(chart_.seconds.high / chart_.seconds.low);
    const double across = (axes_right - axes_left) / decades, up = (axes_above - axes_below) / error_decades;
    const double size = std::min(first_order / up, at_most / across);  // decades
    const double width = size * across, height = size * up;
    const double tall = std::max(2 * height, height + letters) + letters / 2;
    const Rectangle found = free_corner(names + width, tall);
    taken_.push_back(found);
    const double x = found.left + names, y = found.below + 4;
    const double seconds = chart_.seconds.low * std::pow(10, (x - axes_left) / across),
                 error = chart_.error.low * std::pow(10, (y - axes_below) / up), wide = std::pow(10, size);
    for (const int order : {1, 2}) {
      out_.triangles.push_back({order, seconds, error, wide, std::pow(wide, order)});
      const double name = order == 1 ? height : std::max(2 * height, height + letters);
      out_.texts.push_back({found.left, y + name - letters / 4, "order " + std::to_string(order), false, black});
    }
  }

  const ChartLayout& result() const { return out_; }

 private:
  struct Place {
    double x, y;
  };
  Place place(const Dot& dot) const {
    return {pixel_of_seconds(chart_, dot.seconds), pixel_of_error(chart_, dot.error)};
  }

  void take_segment(const Place& from, const Place& to) {
    constexpr double step = 10;  // pixels
    const int parts = 1 + static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / step);
    for (int k = 0; k <= parts; ++k) {
      const double s = double(k) / parts, x = from.x + s * (to.x - from.x), y = from.y + s * (to.y - from.y);
      lines_.push_back({x - line_half, y - line_half, x + line_half, y + line_half});
    }
  }

  Rectangle free_corner(double width, double height) const {
    constexpr double margin = 12, step = 20;  // pixels
    const double right = axes_right - margin - width, top = axes_above - margin - height;
    for (double away = 0; away < axes_right - axes_left + axes_above - axes_below; away += step)
      for (double dx = 0; dx <= away; dx += step) {
        const Rectangle r{right - dx, top - (away - dx), right - dx + width, top - (away - dx) + height};
        if (r.in_axes() && r.is_free_of(taken_) && r.is_free_of(lines_)) return r;
      }
    return {right, top, right + width, top + height};
  }

  bool stands_near(const std::string& label, const Place& at) const {
    constexpr double near = 90;  // pixels
    return std::ranges::any_of(out_.texts, [&](const PlacedText& text) {
      const double x = text.x + text_width(text.text, text.large) / 2;
      return text.text == label && std::hypot(x - at.x, text.y - at.y) < near;
    });
  }

  // Whether no point of another step is nearer to the text, so that it is read as of the point at this place.
  bool is_nearest(const PlacedText& text, const Place& at) const {
    const double own = distance(box(text), at);
    return std::ranges::none_of(steps_, [&](const std::pair<Place, std::string>& other) {
      return other.second != text.text && distance(box(text), other.first) < own;
    });
  }
  static double distance(const Rectangle& r, const Place& at) {
    return std::hypot(std::clamp(at.x, r.left, r.right) - at.x, std::clamp(at.y, r.below, r.above) - at.y);
  }

  void lead(const Place& at, const PlacedText& text) {
    constexpr double off = 14;  // pixels, of the point
    const Rectangle b = box(text);
    const double x = std::clamp(at.x, b.left, b.right), y = std::clamp(at.y, b.below, b.above);
    const double length = std::hypot(x - at.x, y - at.y);
    out_.leaders.push_back({at.x + off * (x - at.x) / length, at.y + off * (y - at.y) / length, x, y, text.colour});
  }

  bool is_free(const PlacedText& text, bool off_lines) const {
    const Rectangle b = box(text);
    return b.in_axes() && b.is_free_of(taken_) && (!off_lines || b.is_free_of(lines_));
  }
  // The last of them where none is free.
  void put_first_free(const std::vector<PlacedText>& places) {
    for (const bool off_lines : {true, false})
      for (const PlacedText& text : places)
        if (is_free(text, off_lines)) return put(text);
    put(places.back());
  }
  void put(const PlacedText& text) {
    taken_.push_back(box(text));
    out_.texts.push_back(text);
  }

  const Chart& chart_;
  std::vector<Rectangle> taken_;  // by points and letters
  std::vector<std::pair<Place, std::string>> steps_;
  std::vector<Rectangle> lines_;  // by lines, over which a label may stand where there is no other room
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
      for (const Dot& dot : line->dots) layer.name(dot, line->ink);
  layer.add_triangles();
  const auto on_front = [&](const Dot& dot) {
    return std::ranges::any_of(chart.front, [&](const Dot& member) { return member.of == dot.of; });
  };
  for (const bool first : {true, false})
    for (const Line& line : chart.lines)
      for (const Dot& dot : line.dots)
        if (!line.title.empty() && on_front(dot) == first) layer.label(dot, line.ink);
  return layer.result();
}

}  // namespace app
