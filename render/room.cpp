#include "render/room.h"

#include <algorithm>
#include <cmath>

#include "render/ruler.h"
#include "render/strip.h"

namespace render {
namespace {

constexpr double letter = 0.58;    // mean width of DejaVu Sans over its size
constexpr double least = 1.0 / 3;  // of either side

double width_of(const std::string& words, double size) {
  const auto begins = [](unsigned char byte) { return (byte & 0xC0U) != 0x80U; };
  return letter * size * static_cast<double>(std::count_if(words.begin(), words.end(), begins));
}

// Moves both ends apart to the least distance.
void keep_open(double& low, double& high) {
  if (high - low >= least) return;
  const double middle = std::clamp((low + high) / 2, least / 2, 1 - least / 2);
  low = middle - least / 2;
  high = middle + least / 2;
}

}  // namespace

float text_size(float width, float height, bool lecture) {
  // Dear ImGui's size of a font is from the top of its highest letters to the bottom of its lowest, 1.164 em of DejaVu
  // Sans; a lecture's letters have an em of 1/28, 1/24 and 1/20 of the height.
  constexpr float per_em = 1.164F;
  const float side = std::min(height, 0.75F * width), page = static_cast<float>(measure_of(width, height));
  // Legible on a small picture, in proportion on a large one; a lecture's pages are the same at every size.
  return std::round(lecture ? std::max(6.0F, per_em * page / 28) : std::max(11.0F, 0.029F * side));
}

namespace {

// What the contents leave free, however little that is.
Box free_room(const Contents& contents, int width, int height) {
  const double w = width, h = height;
  const double size = text_size(static_cast<float>(width), static_cast<float>(height), contents.look.lecture);
  const double margin = 0.9 * size, edge = margin / 2;
  const double left = contents.look.axes ? axes_left * size : edge;
  double right = edge, top = edge, bottom = edge;
  if (!contents.title.empty()) {
    const double across = width_of(contents.title, size), free = w - 2 * margin - left;
    const double scale = std::clamp(free / across, 0.9, 1.3);  // as Overlay draws it
    top = 0.8 * margin + scale * size * std::ceil(scale * across / free - 1e-9);
  }
  if (contents.labels) top += 1.9 * size;
  if (!contents.legend.empty()) right = std::min(width_of(contents.legend + " [MPa]", size), 0.24 * w) + 2 * margin;
  if (contents.look.axes) bottom = axes_below * size;
  if (contents.strips > 0) bottom = (contents.look.axes ? bottom : 0) + margin + strip_height(size, h);
  if (contents.look.scale_bar) bottom += scale_bar_height * size;
  // Where it does not fit beside strips it stands above them.
  const double strips = contents.strips * (std::min(20 * size, 0.5 * w) + margin);
  const bool beside = strips > 0 && width_of(contents.caption, size) <= w - strips - left - 2 * margin;
  if (!contents.caption.empty() && !beside) bottom += margin + 1.2 * size;
  return {left / w, top / h, 1 - right / w, 1 - bottom / h};
}

}  // namespace

bool has_room_for_strips(const Contents& contents, int width, int height) {
  constexpr double quarter = 0.25;
  const Box room = free_room(contents, width, height);
  return room.bottom - room.top >= quarter;
}

Box room_for(const Contents& contents, int width, int height) {
  Box room = free_room(contents, width, height);
  keep_open(room.left, room.right);
  keep_open(room.top, room.bottom);
  return room;
}

}  // namespace render
