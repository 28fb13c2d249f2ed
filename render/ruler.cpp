#include "render/ruler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "render/ticks.h"

namespace render {

namespace {

// Labels of ticks; the last one tells the unit and what all are counted from.
std::vector<std::string> labels_of(std::vector<double> values, const std::string& unit) {
  const double offset = tick_offset(values);
  for (double& value : values) value -= offset;
  std::vector<std::string> labels = tick_labels(values);
  if (!labels.empty()) labels.back() = unit;
  if (offset == 0 || labels.empty()) return labels;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), offset > 0 ? "+ %.0f " : "- %.0f ", std::abs(offset));
  labels.back() = text.data() + unit;
  return labels;
}

}  // namespace

void draw_axes(const Page& page, const View& view, const Frame& frame, float top) {
  const std::string& unit = frame.look.length;
  const double per_unit = page.height / view.extent;                                      // pixels
  const double across = static_cast<double>(view.right.dot(view.eye)) + frame.origin[0],  // at the picture's middle
      along = static_cast<double>(view.up.dot(view.eye)) + frame.origin[1];
  const float left = std::round(axes_left * page.size), floor = std::round(page.height - axes_below * page.size);
  const float length = 0.35F * page.size;
  const auto x_of = [&](double value) { return static_cast<float>(page.width / 2 + (value - across) * per_unit); };
  const auto y_of = [&](double value) { return static_cast<float>(page.height / 2 - (value - along) * per_unit); };
  const auto bar = [&](float x0, float y0, float x1, float y1) {
    page.list->AddRectFilled({x0, y0}, {x1, y1}, Page::soft_ink);
  };
  const float right_end = page.width - page.margin;
  bar(left, page.margin, left + 1, floor);
  bar(left, floor, right_end, floor + 1);

  const std::vector<double> columns =
      ticks(across + (left - page.width / 2) / per_unit, across + (right_end - page.width / 2) / per_unit,
            static_cast<int>(page.width / (6 * page.size)));
  const std::vector<std::string> column_labels = labels_of(columns, unit);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const float x = std::round(x_of(columns[i]));
    bar(x, floor, x + 1, floor + length);
    const float half = page.measure(column_labels[i], 0.85F).x / 2;
    page.write(std::min(x, page.width - half - 2), floor + 1.3F * length, column_labels[i], Align::centre,
               Page::soft_ink, 0.85F);
  }
  const std::vector<double> rows =
      ticks(along - (floor - page.height / 2) / per_unit, along - (page.margin - page.height / 2) / per_unit,
            static_cast<int>(page.height / (4 * page.size)));
  const std::vector<std::string> row_labels = labels_of(rows, unit);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const float y = std::round(y_of(rows[i]));
    bar(left - length, y, left, y + 1);
    const bool fits = page.measure(row_labels[i], 0.85F).x < left - 1.5F * length;
    // What is too long for the room beside the axis stands at its upper end.
    if (fits)
      page.write(left - 1.5F * length, y - 0.45F * page.size, row_labels[i], Align::right, Page::soft_ink, 0.85F);
    else
      page.write(left + length, top, row_labels[i], Align::left, Page::soft_ink, 0.85F);
  }
}

ImVec2 draw_scale_bar(const Page& page, const View& view, const std::string& unit, ImVec2 corner) {
  const float per_unit = page.height / view.extent;
  const double length = round_length(0.22 * page.width / per_unit);
  const auto pixels = static_cast<float>(length * per_unit);
  const float right = corner.x - page.margin / 2, left = right - pixels;
  const float y = std::round(corner.y - 1.2F * page.size);
  const float thick = std::max(2.0F, std::round(0.16F * page.size));
  const ImVec2 low{left - page.size, y - 1.9F * page.size};
  page.lay_plate(low, {right + page.size, y + page.size});
  page.list->AddRectFilled({left, y}, {right, y + thick}, Page::ink);
  for (const float x : {left, right - thick}) {
    page.list->AddRectFilled({x, y - 0.25F * page.size}, {x + thick, y + thick + 0.25F * page.size}, Page::ink);
  }
  page.write((left + right) / 2, y - 1.5F * page.size, tick_labels({length})[0] + " " + unit, Align::centre);
  return low;
}

}  // namespace render
