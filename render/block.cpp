#include "render/block.h"

#include <algorithm>

#include "render/diagram.h"

namespace render {
namespace {

constexpr float line_pitch = 1.06F;  // of lines, of the letters' size
constexpr float least_space = 0.3F;  // between columns

// Writes items down a column; digits have one width, and what is right-aligned keeps its place when they change.
class Column {
 public:
  Column(const Page& page, float left, float right, float top, float bottom)
      : page_(page), left_(left), right_(right), y_(top), bottom_(bottom) {}

  void title(const std::string& text) {
    if (text.empty() || !has_room(1)) return;
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
  // Room for so many lines. Once there is not, nothing follows.
  bool has_room(std::size_t lines) {
    full_ = full_ || y_ + line_pitch * page_.size * static_cast<float>(lines) > bottom_;
    return !full_;
  }
  float width_of(const std::string& text) const { return page_.measure(text).x; }
  // A number's, with room for a sign that it may get: what stands beside it does not move then.
  float width_of(const Number& number) const {
    return width_of(number.text.starts_with('-') ? number.text : "-" + number.text);
  }
  // Of the columns of a table, the labels' first, and what they and the least space between them need.
  struct Widths {
    std::vector<float> of;
    float sum = 0;
  };
  template <class WidthOfNumber>
  Widths widths_of(const Table& table, const WidthOfNumber& width_of_number) const;
  std::vector<float> widths_that_fit(const Table& table) const;
  void bracket(float x, float top, float bottom, float towards) const;

  const Page& page_;
  float left_, right_, y_, bottom_;
  bool full_ = false;
};

// A number that is too wide to stand beside its label stands below it.
void Column::add(const Line& line) {
  const ImU32 colour = colour_of(line.ink);
  const std::string unit = line.number.unit.empty() ? "" : " " + line.number.unit;
  const bool below = width_of(line.label + " " + line.number.text + unit) > right_ - left_;
  if (!has_room(below ? 2 : 1)) return;
  page_.write(left_, y_, line.label, Align::left, colour);
  if (below) y_ += line_pitch * page_.size;
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
  if (!has_room(rows)) return;
  const float pitch = line_pitch * page_.size, height = pitch * static_cast<float>(rows);
  const float space = 0.55F * page_.size, foot = 0.3F * page_.size;
  std::vector<float> widths(columns, 0.0F);
  for (std::size_t k = 0; k < matrix.entries.size(); ++k)
    widths[k % columns] = std::max(widths[k % columns], width_of(matrix.entries[k]));
  float all = space * static_cast<float>(columns + 1);
  for (const float width : widths) all += width;
  const float unit = matrix.unit.empty() ? 0 : width_of(" " + matrix.unit);
  const float end = right_ - unit, begin = end - all, middle = y_ + (height - page_.size) / 2;
  if (left_ + width_of(matrix.label) < begin)
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
  y_ += height + 0.35F * page_.size;
}

template <class WidthOfNumber>
Column::Widths Column::widths_of(const Table& table, const WidthOfNumber& width_of_number) const {
  Widths widths;
  for (const std::string& head : table.head) widths.of.push_back(width_of(head));
  for (const Table::Row& row : table.rows) {
    widths.of[0] = std::max(widths.of[0], width_of(row.label));
    for (std::size_t c = 0; c < row.numbers.size(); ++c)
      widths.of[c + 1] = std::max(widths.of[c + 1], width_of_number(row.numbers[c]));
  }
  for (const float width : widths.of) widths.sum += width;
  widths.sum += least_space * page_.size * static_cast<float>(widths.of.size() - 1);
  return widths;
}

// With room for signs, or else without it, or else fewer columns.
std::vector<float> Column::widths_that_fit(const Table& table) const {
  const float room = right_ - left_;
  Widths widths = widths_of(table, [&](const Number& number) { return width_of(number); });
  if (widths.sum > room) widths = widths_of(table, [&](const Number& number) { return width_of(number.text); });
  while (!widths.of.empty() && widths.sum > room) {
    widths.sum -= widths.of.back() + least_space * page_.size;
    widths.of.pop_back();
  }
  return widths.of;
}

void Column::add(const Table& table) {
  const std::vector<float> widths = widths_that_fit(table);
  const std::size_t columns = widths.size();
  if (columns == 0 || !has_room(1)) return;
  // Right edges of the columns of numbers, from the right.
  float used = widths[0];
  for (std::size_t c = 1; c < columns; ++c) used += widths[c];
  const float space = (right_ - left_ - used) / std::max(1.0F, static_cast<float>(columns - 1));
  const auto edge = [&](std::size_t c) {
    float x = left_ + widths[0];
    for (std::size_t k = 1; k <= c; ++k) x += widths[k] + space;
    return x;
  };
  page_.write(left_, y_, table.head[0], Align::left, colour_of(Ink::black));
  for (std::size_t c = 1; c < columns; ++c)
    page_.write(edge(c), y_, table.head[c], Align::right, colour_of(Ink::black));
  y_ += line_pitch * page_.size;
  for (std::size_t r = 0; r < table.rows.size() && has_room(1); ++r, y_ += line_pitch * page_.size) {
    const Table::Row& row = table.rows[r];
    page_.write(left_, y_, row.label, Align::left, colour_of(row.ink));
    for (std::size_t c = 0; c < std::min(row.numbers.size(), columns - 1); ++c) {
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

void draw_blocks(const Page& page, const Sheet& sheet, float left, float top, float bottom) {
  Column column(page, left, page.width - page.margin, top, bottom);
  for (const Block& block : sheet.blocks) {
    column.title(block.title);
    for (const auto& item : block.items) std::visit([&](const auto& kind) { column.add(kind); }, item);
    column.gap();
  }
}

void draw_proof(const Page& page, const std::string& label, const Number& proof, ImVec2 corner, float left) {
  if (proof.text.empty()) return;
  const float pad = 0.3F * page.size;
  std::string words = proof.text + (proof.unit.empty() ? "" : " " + proof.unit);
  const std::string labelled = label + " " + words;
  if (corner.x - page.measure(labelled).x - 2 * pad > left) words = labelled;
  const ImVec2 size = page.measure(words);
  const ImVec2 low{corner.x - size.x - 2 * pad, corner.y - size.y - 2 * pad};
  page.list->AddRect(low, corner, colour_of(Ink::blue), 0, 0, 1.4F * line_width(page));
  page.write(low.x + pad, low.y + pad, words, Align::left, colour_of(Ink::blue));
}

}  // namespace render
