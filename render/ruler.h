// Lengths in a figure: axes with numbers, a scale bar.
#pragma once

#include <string>

#include "render/frame.h"
#include "render/page.h"
#include "render/view.h"

namespace render {

// What they need of a picture, in heights of the text.
constexpr float axes_left = 3.6F, axes_below = 2.2F, scale_bar_height = 3.6F;

// For parallel cameras. Axes stand at the left and the lower edge and count along the view's right and up, from the
// scene's origin; `top`: where their upper end may be written at. Numbers with many equal digits are counted from a
// round one, which stands at the end.
void draw_axes(const Page& page, const View& view, const Frame& frame, float top);
// As long as a round number of units, above this corner at its right. Returns its upper left corner.
ImVec2 draw_scale_bar(const Page& page, const View& view, const std::string& unit, ImVec2 corner);

}  // namespace render
