#include "render/strip.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/ticks.h"

namespace render {
namespace {

// Okabe and Ito's colours, told apart by the colour-blind, in an order that reads well on white.
constexpr std::array<ImU32, 6> line_colours = {IM_COL32(0, 114, 178, 255),   IM_COL32(213, 94, 0, 255),
                                               IM_COL32(0, 158, 115, 255),   IM_COL32(40, 44, 52, 255),
                                               IM_COL32(204, 121, 167, 255), IM_COL32(230, 159, 0, 255)};

struct Range {
  float low, high;
  float share(float value) const { return (value - low) / (high - low); }
};

// All finite values and zero, with room above.
Range value_range(const Strip& strip) {
  Range range{0, 0};
  for (const Series& series : strip.series) {
    for (const float value : series.values) {
      if (!std::isfinite(value)) continue;
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    }
  }
  if (range.low == range.high) range.high = 1;
  const float room = 0.06F * (range.high - range.low);
  return {range.low < 0 ? range.low - room : 0, range.high + room};
}

void draw_grid(const Page& page, ImVec2 low, ImVec2 high, Range time, Range range) {
  const float small = 0.72F * page.size;
  const auto line = [&](ImVec2 from, ImVec2 to) {
    page.list->AddRectFilled(from, {std::max(to.x, from.x + 1), std::max(to.y, from.y + 1)}, IM_COL32(0, 0, 0, 28));
  };
  const std::vector<double> rows = ticks(range.low, range.high, static_cast<int>((high.y - low.y) / (2.2F * small)));
  const std::vector<std::string> row_labels = tick_labels(rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const float y = std::round(high.y - range.share(static_cast<float>(rows[i])) * (high.y - low.y));
    line({low.x, y}, {high.x, y});
    page.write(low.x - 0.3F * small, y - 0.55F * small, row_labels[i], Align::right, Page::soft_ink, 0.72F);
  }
  const std::vector<double> columns = ticks(time.low, time.high, static_cast<int>((high.x - low.x) / (5 * small)));
  const std::vector<std::string> column_labels = tick_labels(columns);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const float x = std::round(low.x + time.share(static_cast<float>(columns[i])) * (high.x - low.x));
    line({x, low.y}, {x, high.y});
    const bool last = i + 1 == columns.size();
    page.write(x, high.y + 0.2F * small, column_labels[i] + (last ? " s" : ""), Align::centre, Page::soft_ink, 0.72F);
  }
}

void draw_series(const Page& page, const Strip& strip, const Series& series, ImVec2 low, ImVec2 high, Range time,
                 Range range, ImU32 colour) {
  std::vector<ImVec2> points;
  const auto flush = [&] {
    page.list->AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0,
                           std::max(1.2F, 0.085F * page.size));
    points.clear();
  };
  for (std::size_t i = 0; i < strip.times.size(); ++i) {
    if (!std::isfinite(series.values[i])) {
      flush();
      continue;
    }
    const ImVec2 point{low.x + time.share(strip.times[i]) * (high.x - low.x),
                       high.y - range.share(series.values[i]) * (high.y - low.y)};
    // Points closer than half a pixel add nothing but corners.
    if (!points.empty() && i + 1 < strip.times.size() && point.x - points.back().x < 0.5F &&
        std::abs(point.y - points.back().y) < 0.5F) {
      continue;
    }
    points.push_back(point);
  }
  flush();
}

}  // namespace

void draw_strip(const Page& page, const Strip& strip, ImVec2 low, ImVec2 high) {
  const float small = 0.72F * page.size;
  page.lay_plate(low, high);
  float x = low.x + 0.6F * small;
  const float heading = low.y + 0.35F * small;
  const std::string title = strip.unit.empty() ? strip.title : strip.title + " [" + strip.unit + "]";
  page.write(x, heading, title, Align::left, Page::ink, 0.72F);
  x += page.measure(title, 0.72F).x + 1.2F * small;
  for (std::size_t i = 0; i < strip.series.size(); ++i) {
    const float length = page.measure(strip.series[i].name, 0.72F).x;
    if (x + 1.3F * small + length > high.x) break;  // what does not fit is left out
    const ImU32 colour = line_colours[i % line_colours.size()];
    const float middle = heading + 0.5F * small;
    page.list->AddRectFilled({x, middle - 0.1F * small}, {x + small, middle + 0.1F * small}, colour);
    page.write(x + 1.3F * small, heading, strip.series[i].name, Align::left, Page::soft_ink, 0.72F);
    x += length + 2.2F * small;
  }
  const ImVec2 inner_low{low.x + 4.2F * small, low.y + 1.9F * small};
  const ImVec2 inner_high{high.x - 1.6F * small, high.y - 1.7F * small};
  const float end = std::max(strip.until, strip.times.empty() ? 0.0F : strip.times.back());
  const float begin = strip.times.empty() ? 0.0F : strip.times.front();
  const Range time{begin, end > begin ? end : begin + 1};
  const Range range = value_range(strip);
  draw_grid(page, inner_low, inner_high, time, range);
  for (std::size_t i = 0; i < strip.series.size(); ++i) {
    draw_series(page, strip, strip.series[i], inner_low, inner_high, time, range,
                line_colours[i % line_colours.size()]);
  }
}

float strip_height(double text, double picture) {
  return static_cast<float>(std::max(0.22 * picture, 6 * text));
}

ImVec2 draw_strips(const Page& page, const std::vector<Strip>& strips, float below) {
  if (strips.empty()) return {page.width, page.height};
  float right = page.width - page.margin;
  const float width = std::min(20 * page.size, 0.5F * page.width);
  const float bottom = page.height - page.margin - below, top = bottom - strip_height(page.size, page.height);
  for (auto strip = strips.rbegin(); strip != strips.rend(); ++strip) {
    draw_strip(page, *strip, {right - width, top}, {right, bottom});
    right -= width + page.margin;
  }
  return {right, top};
}

}  // namespace render
