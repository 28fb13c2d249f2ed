// What text and plots are drawn with: a draw list, fonts and sizes that fit the picture.
#pragma once

#include <imgui.h>

#include <string>

namespace render {

enum class Align { left, centre, right };

struct Page {
  ImDrawList* list = nullptr;
  ImFont* text = nullptr;
  ImFont* bold = nullptr;
  float width = 1, height = 1;  // of the picture, pixels
  float size = 11;              // of the text, pixels
  float margin = 11;            // between the picture's edge and what stands in it

  static constexpr ImU32 ink = IM_COL32(28, 33, 40, 255);
  static constexpr ImU32 soft_ink = IM_COL32(86, 94, 104, 255);
  static constexpr ImU32 plate = IM_COL32(255, 255, 255, 150);

  // Width and height of the text, lines parted by \n or wrapped at `wrap` pixels (0: not).
  ImVec2 measure(const std::string& words, float scale = 1, float wrap = 0) const;
  // Writes with the upper edge at y; x is the left end, the middle or the right end of each whole block.
  void write(float x, float y, const std::string& words, Align align = Align::left, ImU32 colour = ink, float scale = 1,
             float wrap = 0) const;
  // A light, rounded rectangle behind text, so that it can be read over anything.
  void lay_plate(ImVec2 low, ImVec2 high) const;
};

}  // namespace render
