#include "render/ruler.h"

#include <cmath>

#include "render/ticks.h"

namespace render {

void draw_axes(const Page& page, const View& view, const std::string& unit) {
  const float per_unit = page.height / view.extent;                              // pixels
  const float across = view.right.dot(view.eye), along = view.up.dot(view.eye);  // at the picture's middle
  const float left = std::round(3.6F * page.size), floor = std::round(page.height - 2.2F * page.size);
  const float length = 0.35F * page.size;
  const auto x_of = [&](double value) { return page.width / 2 + (static_cast<float>(value) - across) * per_unit; };
  const auto y_of = [&](double value) { return page.height / 2 - (static_cast<float>(value) - along) * per_unit; };
  const auto bar = [&](float x0, float y0, float x1, float y1) {
    page.list->AddRectFilled({x0, y0}, {x1, y1}, Page::soft_ink);
  };
  const float right_end = page.width - page.margin;
  bar(left, page.margin, left + 1, floor);
  bar(left, floor, right_end, floor + 1);

  const std::vector<double> columns =
      ticks(across + (left - page.width / 2) / per_unit, across + (right_end - page.width / 2) / per_unit,
            static_cast<int>(page.width / (6 * page.size)));
  const std::vector<std::string> column_labels = tick_labels(columns);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const float x = std::round(x_of(columns[i]));
    bar(x, floor, x + 1, floor + length);
    const std::string label = i + 1 == columns.size() ? unit : column_labels[i];
    page.write(x, floor + 1.3F * length, label, Align::centre, Page::soft_ink, 0.85F);
  }
  const std::vector<double> rows =
      ticks(along - (floor - page.height / 2) / per_unit, along - (page.margin - page.height / 2) / per_unit,
            static_cast<int>(page.height / (4 * page.size)));
  const std::vector<std::string> row_labels = tick_labels(rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const float y = std::round(y_of(rows[i]));
    bar(left - length, y, left, y + 1);
    const std::string label = i + 1 == rows.size() ? unit : row_labels[i];
    page.write(left - 1.5F * length, y - 0.45F * page.size, label, Align::right, Page::soft_ink, 0.85F);
  }
}

void draw_scale_bar(const Page& page, const View& view, const std::string& unit) {
  const float per_unit = page.height / view.extent;
  const double length = round_length(0.22 * page.width / per_unit);
  const auto pixels = static_cast<float>(length * per_unit);
  const float right = page.width - 1.5F * page.margin, left = right - pixels;
  const float y = std::round(page.height - 3.4F * page.size);
  const float thick = std::max(2.0F, std::round(0.16F * page.size));
  page.lay_plate({left - page.size, y - 1.9F * page.size}, {right + page.size, y + page.size});
  page.list->AddRectFilled({left, y}, {right, y + thick}, Page::ink);
  for (const float x : {left, right - thick}) {
    page.list->AddRectFilled({x, y - 0.25F * page.size}, {x + thick, y + thick + 0.25F * page.size}, Page::ink);
  }
  page.write((left + right) / 2, y - 1.5F * page.size, tick_labels({length})[0] + " " + unit, Align::centre);
}

}  // namespace render
