#include "render/block.h"

#include <algorithm>

#include "render/diagram.h"

namespace render {
namespace {

constexpr float line_pitch = 1.06F;  // of lines, of the letters' size

// Writes items down a column; digits have one width, and what is right-aligned keeps its place when they change.
class Column {
 public:
  Column(const Page& page, float left, float right, float top) : page_(page), left_(left), right_(right), y_(top) {}

  void title(const std::string& text) {
    if (text.empty()) return;
    Page heading = page_;
    heading.text = page_.bold;
    heading.write(left_, y_, text, Align::left, colour_of(Ink::black));
    y_ += line_pitch * page_.size;
  }
  void gap() { y_ += 0.4F * page_.size; }
  void add(const Line& line);
  void add(const Matrix& matrix);
  void add(const Table& table);

 private:
  float width_of(const std::string& text) const { return page_.measure(text).x; }
  void bracket(float x, float top, float bottom, float towards) const;

  const Page& page_;
  float left_, right_, y_;
};

void Column::add(const Line& line) {
  const ImU32 colour = colour_of(line.ink);
  page_.write(left_, y_, line.label, Align::left, colour);
  const std::string unit = line.number.unit.empty() ? "" : " " + line.number.unit;
  page_.write(right_ - width_of(unit), y_, line.number.text, Align::right, colour);
  page_.write(right_, y_, unit, Align::right, colour);
  y_ += line_pitch * page_.size;
}

// One half of a pair of brackets; its ends point `towards` the numbers.
void Column::bracket(float x, float top, float bottom, float towards) const {
  const ImVec2 points[] = {{x + towards, top}, {x, top}, {x, bottom}, {x + towards, bottom}};
  page_.list->AddPolyline(points, 4, colour_of(Ink::black), 0, line_width(page_));
}

void Column::add(const Matrix& matrix) {
  const auto columns = static_cast<std::size_t>(matrix.columns);
  const std::size_t rows = matrix.entries.size() / columns;
  const float pitch = line_pitch * page_.size, height = pitch * static_cast<float>(rows);
  const float space = 0.55F * page_.size, foot = 0.3F * page_.size;
  std::vector<float> widths(columns, 0.0F);
  for (std::size_t k = 0; k < matrix.entries.size(); ++k)
    widths[k % columns] = std::max(widths[k % columns], width_of(matrix.entries[k].text));
  float all = space * static_cast<float>(columns + 1);
  for (const float width : widths) all += width;
  const float unit = matrix.unit.empty() ? 0 : width_of(" " + matrix.unit);
  const float end = right_ - unit, begin = end - all, middle = y_ + (height - page_.size) / 2;
  page_.write(left_, middle, matrix.label, Align::left, colour_of(Ink::black));
  if (unit > 0) page_.write(right_, middle, matrix.unit, Align::right, colour_of(Ink::black));
  bracket(begin, y_, y_ + height, foot);
  bracket(end, y_, y_ + height, -foot);
  for (std::size_t k = 0; k < matrix.entries.size(); ++k) {
    float x = begin + space;
    for (std::size_t c = 0; c <= k % columns; ++c) x += widths[c] + (c > 0 ? space : 0);
    page_.write(x, y_ + pitch * static_cast<float>(k / columns), matrix.entries[k].text, Align::right,
                colour_of(Ink::black));
  }
  y_ += height + 0.25F * page_.size;
}

void Column::add(const Table& table) {
  const std::size_t columns = table.head.size();
  std::vector<float> widths(columns, 0.0F);
  for (std::size_t c = 0; c < columns; ++c) widths[c] = width_of(table.head[c]);
  for (const Table::Row& row : table.rows) {
    widths[0] = std::max(widths[0], width_of(row.label));
    for (std::size_t c = 0; c < row.numbers.size(); ++c)
      widths[c + 1] = std::max(widths[c + 1], width_of(row.numbers[c].text));
  }
  // Right edges of the columns of numbers, from the right.
  float used = widths[0];
  for (std::size_t c = 1; c < columns; ++c) used += widths[c];
  const float space =
      std::max(0.3F * page_.size, (right_ - left_ - used) / std::max(1.0F, static_cast<float>(columns - 1)));
  const auto edge = [&](std::size_t c) {
    float x = left_ + widths[0];
    for (std::size_t k = 1; k <= c; ++k) x += widths[k] + space;
    return x;
  };
  page_.write(left_, y_, table.head[0], Align::left, colour_of(Ink::black));
  for (std::size_t c = 1; c < columns; ++c)
    page_.write(edge(c), y_, table.head[c], Align::right, colour_of(Ink::black));
  y_ += line_pitch * page_.size;
  for (std::size_t r = 0; r < table.rows.size(); ++r, y_ += line_pitch * page_.size) {
    const Table::Row& row = table.rows[r];
    page_.write(left_, y_, row.label, Align::left, colour_of(row.ink));
    for (std::size_t c = 0; c < row.numbers.size(); ++c) {
      page_.write(edge(c + 1), y_, row.numbers[c].text, Align::right, colour_of(row.ink));
      const std::array<int, 2> place = {static_cast<int>(r), static_cast<int>(c)};
      if (std::find(table.boxed.begin(), table.boxed.end(), place) == table.boxed.end()) continue;
      const float pad = 0.12F * page_.size, right = edge(c + 1);
      page_.list->AddRect({right - width_of(row.numbers[c].text) - pad, y_}, {right + pad, y_ + page_.size},
                          colour_of(Ink::blue), 0, 0, line_width(page_));
    }
  }
}

}  // namespace

void draw_blocks(const Page& page, const Sheet& sheet, float left, float top) {
  Column column(page, left, page.width - page.margin, top);
  for (const Block& block : sheet.blocks) {
    column.title(block.title);
    for (const auto& item : block.items) std::visit([&](const auto& kind) { column.add(kind); }, item);
    column.gap();
  }
}

void draw_proof(const Page& page, const std::string& label, const Number& proof, ImVec2 corner) {
  if (proof.text.empty()) return;
  const std::string words = label + " " + proof.text + (proof.unit.empty() ? "" : " " + proof.unit);
  const ImVec2 size = page.measure(words);
  const float pad = 0.3F * page.size;
  const ImVec2 low{corner.x - size.x - 2 * pad, corner.y - size.y - 2 * pad};
  page.list->AddRect(low, corner, colour_of(Ink::blue), 0, 0, 1.4F * line_width(page));
  page.write(low.x + pad, low.y + pad, words, Align::left, colour_of(Ink::blue));
}

}  // namespace render
