#include "render/diagram.h"

#include <algorithm>
#include <cmath>

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
  void draw(const Stroke& stroke) const;
  void draw(const Dart& dart) const;
  void draw(const Dot& dot) const;
  void draw(const Word& word) const;

 private:
  void ticks_across(float low, float high, float bottom) const;
  void ticks_up(float left, float bottom, float top) const;

  const Page& page_;
  const Diagram& diagram_;
};

void Easel::ticks_across(float low, float high, float bottom) const {
  const std::vector<double> places =
      ticks(diagram_.x[0], diagram_.x[1], std::max(2, static_cast<int>((high - low) / (5 * page_.size))));
  const std::vector<std::string> labels = tick_labels(places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const float x = at({places[i], diagram_.y[0]}).x;
    page_.list->AddLine({x, bottom}, {x, bottom - 0.3F * page_.size}, colour_of(Ink::black), line_width(page_));
    page_.write(x, bottom + 0.15F * page_.size, labels[i], Align::centre, colour_of(Ink::black));
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
  const float below = low.y + (diagram_.axes ? 1.25F : 0.1F) * page_.size;
  if (!diagram_.x_label.empty()) page_.write((low.x + high.x) / 2, below, diagram_.x_label, Align::centre, black);
  if (!diagram_.y_label.empty()) page_.write(low.x + 0.5F * page_.size, high.y, diagram_.y_label, Align::left, black);
}

void Easel::draw(const Patch& patch) const {
  std::vector<ImVec2> points;
  for (const Spot& spot : patch.points) points.push_back(at(spot));
  const auto [r, g, b] = patch.colour;
  page_.list->AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), IM_COL32(r, g, b, 255));
}

void Easel::draw(const Stroke& stroke) const {
  std::vector<ImVec2> points;
  for (const Spot& spot : stroke.points) points.push_back(at(spot));
  if (stroke.closed && !points.empty()) points.push_back(points.front());
  const float width = stroke.width * line_width(page_);
  const ImU32 colour = colour_of(stroke.ink);
  if (!stroke.dashed) {
    page_.list->AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, width);
    return;
  }
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

void Easel::draw(const Dart& dart) const {
  const ImVec2 a = at(dart.from), b = at(dart.to);
  const float length = std::hypot(b.x - a.x, b.y - a.y), width = 1.2F * line_width(page_);
  if (!(length > 0.5F)) return;
  const ImVec2 along{(b.x - a.x) / length, (b.y - a.y) / length}, side{-along.y, along.x};
  const float head = std::min(0.6F * page_.size, 0.6F * length), half = 0.45F * head;
  const ImVec2 neck{b.x - head * along.x, b.y - head * along.y};
  page_.list->AddLine(a, neck, colour_of(dart.ink), width);
  page_.list->AddTriangleFilled(b, {neck.x + half * side.x, neck.y + half * side.y},
                                {neck.x - half * side.x, neck.y - half * side.y}, colour_of(dart.ink));
}

void Easel::draw(const Dot& dot) const {
  const ImVec2 place = at(dot.at);
  const float radius = 0.22F * page_.size;
  page_.list->AddCircleFilled(place, radius, colour_of(dot.ink));
  if (dot.ring) page_.list->AddCircle(place, 2.4F * radius, colour_of(dot.ink), 0, line_width(page_));
}

void Easel::draw(const Word& word) const {
  const ImVec2 place = at(word.at);
  const float gap = 0.6F * page_.size, half = 0.5F * page_.size;
  const ImU32 colour = colour_of(word.ink);
  switch (word.side) {
    case Side::right:
      return page_.write(place.x + gap, place.y - half, word.text, Align::left, colour);
    case Side::left:
      return page_.write(place.x - gap, place.y - half, word.text, Align::right, colour);
    case Side::above:
      return page_.write(place.x, place.y - gap - 2 * half, word.text, Align::centre, colour);
    case Side::below:
      return page_.write(place.x, place.y + gap, word.text, Align::centre, colour);
    case Side::middle:
      return page_.write(place.x, place.y - half, word.text, Align::centre, colour);
  }
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
  for (const Patch& patch : diagram.patches) easel.draw(patch);
  easel.frame();
  // Curves end where the axes do.
  const ImVec2 low = easel.at({diagram.x[0], diagram.y[1]}), high = easel.at({diagram.x[1], diagram.y[0]});
  if (diagram.axes) page.list->PushClipRect({low.x, low.y - 2}, {high.x + 2, high.y + 2}, true);
  for (const Stroke& stroke : diagram.strokes) easel.draw(stroke);
  if (diagram.axes) page.list->PopClipRect();
  for (const Dart& dart : diagram.darts) easel.draw(dart);
  for (const Dot& dot : diagram.dots) easel.draw(dot);
  for (const Word& word : diagram.words) easel.draw(word);
}

}  // namespace render
