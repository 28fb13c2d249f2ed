// Quantities over time, as small plots.
#pragma once

#include "render/frame.h"
#include "render/page.h"

namespace render {

// Height of a strip [pixels] with letters of this size in a picture of this height.
float strip_height(double text, double picture);

// Draws the strips side by side, the last one in the lower right corner, above what needs `below` pixels. Returns the
// upper left corner of what was drawn, the picture's lower right corner without strips.
ImVec2 draw_strips(const Page& page, const std::vector<Strip>& strips, float below);

// Draws one between two corners.
void draw_strip(const Page& page, const Strip& strip, ImVec2 low, ImVec2 high);

}  // namespace render
