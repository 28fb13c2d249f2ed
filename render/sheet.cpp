#include "render/sheet.h"

#include <algorithm>

namespace render {
namespace {

// Pixels of the rectangle that the ranges of a diagram fill, and the ranges that do: with the same scale along both,
// one of them is widened about its middle.
struct Frameless {
  double left, top, width, height;
  std::array<double, 2> x, y;
};

Frameless inner(const Diagram& d, double width, double height) {
  const double letter = measure_of(width, height) / 24;  // room for a title and numbers at the axes
  Frameless f{d.place.left * width,
              d.place.top * height,
              (d.place.right - d.place.left) * width,
              (d.place.bottom - d.place.top) * height,
              d.x,
              d.y};
  // The number at the upper end of an axis is half above it.
  const double above = d.title.empty() ? 0.3 * letter : (d.axes ? 1.6 : 1.3) * letter;
  f.top += above;
  f.height -= above;
  if (d.axes) {
    f.left += 3.1 * letter;
    f.width -= 3.6 * letter;
    f.height -= 1.4 * letter;
  }
  if (!d.x_label.empty()) f.height -= letter;
  f.width = std::max(f.width, 1.0);
  f.height = std::max(f.height, 1.0);
  if (!d.equal) return f;
  const double across = (f.x[1] - f.x[0]) / f.width, upwards = (f.y[1] - f.y[0]) / f.height;
  const auto widen = [](std::array<double, 2>& range, double extent) {
    const double middle = (range[0] + range[1]) / 2;
    range = {middle - extent / 2, middle + extent / 2};
  };
  if (across > upwards) {
    widen(f.y, across * f.height);
  } else {
    widen(f.x, upwards * f.width);
  }
  return f;
}

// A line without a number is words only.
void add(const Line& line, std::vector<Number>& all) {
  if (!line.number.name.empty()) all.push_back(line.number);
}
void add(const Matrix& matrix, std::vector<Number>& all) {
  for (Number entry : matrix.entries) {
    entry.unit = matrix.unit;
    all.push_back(std::move(entry));
  }
}
void add(const Table& table, std::vector<Number>& all) {
  for (const Table::Row& row : table.rows) all.insert(all.end(), row.numbers.begin(), row.numbers.end());
}

}  // namespace

std::array<int, 3> ink_colour(Ink ink) {
  switch (ink) {
    case Ink::blue:
      return {0, 0, 205};
    case Ink::red:
      return {100, 0, 0};
    case Ink::purple:
      return {62, 0, 110};
    case Ink::black:
      break;
  }
  return {8, 9, 12};
}

std::vector<Number> numbers_of(const Sheet& sheet) {
  std::vector<Number> all;
  for (const Block& block : sheet.blocks)
    for (const auto& item : block.items) std::visit([&](const auto& kind) { add(kind, all); }, item);
  if (!sheet.proof.text.empty()) all.push_back(sheet.proof);
  return all;
}

double measure_of(double width, double height) {
  return std::min(height, width * 9 / 16);
}

Box area_of(const Diagram& diagram, double width, double height) {
  const Frameless f = inner(diagram, width, height);
  return {f.left, f.top, f.left + f.width, f.top + f.height};
}

Spot to_page(const Diagram& diagram, const Spot& spot, double width, double height) {
  const Frameless f = inner(diagram, width, height);
  return {f.left + (spot[0] - f.x[0]) / (f.x[1] - f.x[0]) * f.width,
          f.top + (f.y[1] - spot[1]) / (f.y[1] - f.y[0]) * f.height};
}

Spot from_page(const Diagram& diagram, const Spot& pixel, double width, double height) {
  const Frameless f = inner(diagram, width, height);
  return {f.x[0] + (pixel[0] - f.left) / f.width * (f.x[1] - f.x[0]),
          f.y[1] - (pixel[1] - f.top) / f.height * (f.y[1] - f.y[0])};
}

}  // namespace render
