// Lengths in a figure: axes with numbers, a scale bar.
#pragma once

#include <string>

#include "render/page.h"
#include "render/view.h"

namespace render {

// For parallel cameras. Axes stand at the left and the lower edge and count along the view's right and up; the scale
// bar stands at the lower right, as long as a round number of units.
void draw_axes(const Page& page, const View& view, const std::string& unit);
void draw_scale_bar(const Page& page, const View& view, const std::string& unit);

}  // namespace render
