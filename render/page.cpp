#include "render/page.h"

#include <cfloat>
#include <cmath>

namespace render {

ImVec2 Page::measure(const std::string& words, float scale, float wrap) const {
  return text->CalcTextSizeA(size * scale, FLT_MAX, wrap, words.data(), words.data() + words.size());
}

void Page::write(float x, float y, const std::string& words, Align align, ImU32 colour, float scale, float wrap) const {
  if (align != Align::left) {
    const float length = measure(words, scale, wrap).x;
    x -= align == Align::centre ? length / 2 : length;
  }
  // Whole pixels keep the letters sharp.
  list->AddText(text, size * scale, {std::round(x), std::round(y)}, colour, words.data(), words.data() + words.size(),
                wrap);
}

void Page::lay_plate(ImVec2 low, ImVec2 high) const {
  list->AddRectFilled(low, high, plate, 0.35F * size);
}

}  // namespace render
