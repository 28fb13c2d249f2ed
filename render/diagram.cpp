#include "render/diagram.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/ticks.h"

namespace render {
namespace {

// A diagram on its page: where spots are in pixels.
class Easel {
 public:
  Easel(const Page& page, const Diagram& diagram) : page_(page), diagram_(diagram) {}
  ImVec2 at(const Spot& spot) const {
    const Spot pixel = to_page(diagram_, spot, page_.width, page_.height);
    return {static_cast<float>(pixel[0]), static_cast<float>(pixel[1])};
  }

  void frame() const;
  void draw(const Patch& patch) const;
  void draw(const Stroke& stroke) const { draw(stroke, colour_of(stroke.ink), stroke.width * line_width(page_)); }
  void draw(const Dart& dart) const;
  void draw(const Dot& dot) const;
  void draw(const Word& word) const;
  // The white border of what lies over a filled area: it is read on any colour, by a washed-out projector as well.
  void lay_border(const Stroke& stroke) const { draw(stroke, white, stroke.width * line_width(page_) + 2 * border()); }
  void lay_border(const Dart& dart) const;
  void lay_border(const Dot& dot) const;
  void lay_border(const Word& word) const;

 private:
  static constexpr ImU32 white = IM_COL32_WHITE;

  float border() const { return 0.7F * line_width(page_); }
  void draw(const Stroke& stroke, ImU32 colour, float width) const;
  struct Arrow;
  std::optional<Arrow> arrow_of(const Dart& dart) const;
  ImVec2 corner_of(const Word& word) const;
  void ticks_across(float low, float high, float bottom) const;
  void ticks_up(float left, float bottom, float top) const;

  const Page& page_;
  const Diagram& diagram_;
};

void Easel::ticks_across(float low, float high, float bottom) const {
  std::vector<Tick> marks = diagram_.x_ticks;
  if (marks.empty()) {
    const std::vector<double> places =
        ticks(diagram_.x[0], diagram_.x[1], std::max(2, static_cast<int>((high - low) / (5 * page_.size))));
    const std::vector<std::string> labels = tick_labels(places);
    for (std::size_t i = 0; i < places.size(); ++i) marks.push_back({places[i], labels[i]});
  }
  for (const Tick& mark : marks) {
    const float x = at({mark.at, diagram_.y[0]}).x;
    page_.list->AddLine({x, bottom}, {x, bottom - 0.3F * page_.size}, colour_of(Ink::black), line_width(page_));
    page_.write(x, bottom + 0.3F * page_.size, mark.label, Align::centre, colour_of(Ink::black));
  }
}

void Easel::ticks_up(float left, float bottom, float top) const {
  const std::vector<double> places =
      ticks(diagram_.y[0], diagram_.y[1], std::max(2, static_cast<int>((bottom - top) / (2.2F * page_.size))));
  std::vector<std::string> labels = tick_labels(places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (diagram_.logarithmic) {
      if (places[i] != std::round(places[i])) continue;
      labels[i] = power_of_ten(static_cast<int>(places[i]));
    }
    const float y = at({diagram_.x[0], places[i]}).y;
    page_.list->AddLine({left, y}, {left + 0.3F * page_.size, y}, colour_of(Ink::black), line_width(page_));
    page_.write(left - 0.25F * page_.size, y - 0.5F * page_.size, labels[i], Align::right, colour_of(Ink::black));
  }
}

// Title, axes with their numbers, labels.
void Easel::frame() const {
  const ImVec2 low = at({diagram_.x[0], diagram_.y[0]}), high = at({diagram_.x[1], diagram_.y[1]});
  const ImU32 black = colour_of(Ink::black);
  const float left = static_cast<float>(diagram_.place.left) * page_.width;
  if (!diagram_.title.empty())
    page_.write(left, static_cast<float>(diagram_.place.top) * page_.height, diagram_.title, Align::left, black);
  if (diagram_.axes) {
    const float width = line_width(page_);
    page_.list->AddLine({low.x, low.y}, {high.x, low.y}, black, width);
    page_.list->AddLine({low.x, low.y}, {low.x, high.y}, black, width);
    ticks_across(low.x, high.x, low.y);
    ticks_up(low.x, low.y, high.y);
  }
  const float below = low.y + (diagram_.axes ? 1.3F : 0.1F) * page_.size;
  if (!diagram_.x_label.empty()) page_.write((low.x + high.x) / 2, below, diagram_.x_label, Align::centre, black);
  if (!diagram_.y_label.empty()) page_.write(low.x + 0.5F * page_.size, high.y, diagram_.y_label, Align::left, black);
}

void Easel::draw(const Patch& patch) const {
  std::vector<ImVec2> points;
  for (const Spot& spot : patch.points) points.push_back(at(spot));
  const auto [r, g, b] = patch.colour;
  page_.list->AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), IM_COL32(r, g, b, 255));
}

void Easel::draw(const Stroke& stroke, ImU32 colour, float width) const {
  std::vector<ImVec2> points;
  for (const Spot& spot : stroke.points) points.push_back(at(spot));
  if (!stroke.dashed) {
    const ImDrawFlags closed = stroke.closed ? ImDrawFlags_Closed : ImDrawFlags_None;
    page_.list->AddPolyline(points.data(), static_cast<int>(points.size()), colour, closed, width);
    return;
  }
  if (stroke.closed && !points.empty()) points.push_back(points.front());
  // Dashes of the same length whatever the polyline's points are.
  const float dash = 4 * line_width(page_);
  float done = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const ImVec2 a = points[i - 1], b = points[i];
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    for (float s = 0; s < length;) {
      const float into = std::fmod(done + s, 2 * dash);
      const float end = std::min(length, s + (into < dash ? dash - into : 2 * dash - into) + 1e-3F);
      const auto on = [&](float q) { return ImVec2(a.x + q / length * (b.x - a.x), a.y + q / length * (b.y - a.y)); };
      if (into < dash) page_.list->AddLine(on(s), on(end), colour, width);
      s = end;
    }
    done += length;
  }
}

// Where its point and the corners of its head are; none where it is too short to be seen.
struct Easel::Arrow {
  ImVec2 tail, neck, left, right, tip;
};

std::optional<Easel::Arrow> Easel::arrow_of(const Dart& dart) const {
  const ImVec2 a = at(dart.from), b = at(dart.to);
  const float length = std::hypot(b.x - a.x, b.y - a.y);
  if (!(length > 0.5F)) return std::nullopt;
  const ImVec2 along{(b.x - a.x) / length, (b.y - a.y) / length}, side{-along.y, along.x};
  const float head = std::min(0.6F * page_.size, 0.6F * length), half = 0.45F * head;
  const ImVec2 neck{b.x - head * along.x, b.y - head * along.y};
  return Arrow{
      a, neck, {neck.x + half * side.x, neck.y + half * side.y}, {neck.x - half * side.x, neck.y - half * side.y}, b};
}

void Easel::draw(const Dart& dart) const {
  const std::optional<Arrow> arrow = arrow_of(dart);
  if (!arrow) return;
  page_.list->AddLine(arrow->tail, arrow->neck, colour_of(dart.ink), 1.2F * line_width(page_));
  page_.list->AddTriangleFilled(arrow->tip, arrow->left, arrow->right, colour_of(dart.ink));
}

void Easel::lay_border(const Dart& dart) const {
  const std::optional<Arrow> arrow = arrow_of(dart);
  if (!arrow) return;
  page_.list->AddLine(arrow->tail, arrow->neck, white, 1.2F * line_width(page_) + 2 * border());
  page_.list->AddTriangle(arrow->tip, arrow->left, arrow->right, white, 2 * border());
}

void Easel::draw(const Dot& dot) const {
  const ImVec2 place = at(dot.at);
  const float radius = 0.22F * page_.size;
  page_.list->AddCircleFilled(place, radius, colour_of(dot.ink));
  if (dot.ring) page_.list->AddCircle(place, 2.4F * radius, colour_of(dot.ink), 0, line_width(page_));
}

void Easel::lay_border(const Dot& dot) const {
  const ImVec2 place = at(dot.at);
  const float radius = 0.22F * page_.size;
  page_.list->AddCircleFilled(place, radius + border(), white);
  if (dot.ring) page_.list->AddCircle(place, 2.4F * radius, white, 0, line_width(page_) + 2 * border());
}

// The upper left corner of a word beside its spot, moved so that the word lies inside the diagram's place.
ImVec2 Easel::corner_of(const Word& word) const {
  const ImVec2 place = at(word.at), size = page_.measure(word.text);
  const float gap = 0.6F * page_.size;
  ImVec2 corner{place.x - size.x / 2, place.y - size.y / 2};
  if (word.side == Side::right) corner.x = place.x + gap;
  if (word.side == Side::left) corner.x = place.x - gap - size.x;
  if (word.side == Side::above) corner.y = place.y - gap - size.y;
  if (word.side == Side::below) corner.y = place.y + gap;
  const auto inside = [](float start, float length, double low, double high) {
    return std::max(static_cast<float>(low), std::min(start, static_cast<float>(high) - length));
  };
  const Box& box = diagram_.place;
  return {inside(corner.x, size.x, box.left * page_.width, box.right * page_.width),
          inside(corner.y, size.y, box.top * page_.height, box.bottom * page_.height)};
}

void Easel::draw(const Word& word) const {
  const ImVec2 corner = corner_of(word);
  page_.write(corner.x, corner.y, word.text, Align::left, colour_of(word.ink));
}

void Easel::lay_border(const Word& word) const {
  const ImVec2 corner = corner_of(word);
  for (const float x : {-border(), 0.0F, border()})
    for (const float y : {-border(), 0.0F, border()})
      page_.write(corner.x + x, corner.y + y, word.text, Align::left, white);
}

}  // namespace

ImU32 colour_of(Ink ink) {
  const auto [r, g, b] = ink_colour(ink);
  return IM_COL32(r, g, b, 255);
}

float line_width(const Page& page) {
  return std::max(1.0F, page.height / 240);
}

void draw_diagram(const Page& page, const Diagram& diagram) {
  const Easel easel(page, diagram);
  // Curves end where the axes do; a drawing keeps to its place, with some room for arrows and rings.
  const Box area = area_of(diagram, page.width, page.height);
  const float room = diagram.axes ? 0.5F * line_width(page) : 0.3F * page.size;
  const ImVec2 low{static_cast<float>(area.left) - room, static_cast<float>(area.top) - room};
  const ImVec2 high{static_cast<float>(area.right) + room, static_cast<float>(area.bottom) + room};
  page.list->PushClipRect(low, high, true);
  for (const Patch& patch : diagram.patches) easel.draw(patch);
  // All borders are below all lines, so that lines that cross are whole.
  if (!diagram.patches.empty()) {
    for (const Stroke& stroke : diagram.strokes) easel.lay_border(stroke);
    for (const Dart& dart : diagram.darts) easel.lay_border(dart);
    for (const Dot& dot : diagram.dots) easel.lay_border(dot);
  }
  for (const Stroke& stroke : diagram.strokes) easel.draw(stroke);
  for (const Dart& dart : diagram.darts) easel.draw(dart);
  // The last dot of a curve is whole.
  if (diagram.axes) page.list->PopClipRect();
  for (const Dot& dot : diagram.dots) easel.draw(dot);
  if (!diagram.axes) page.list->PopClipRect();
  easel.frame();
  for (const Word& word : diagram.words) {
    if (!diagram.patches.empty()) easel.lay_border(word);
    easel.draw(word);
  }
}

}  // namespace render
