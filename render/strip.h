// Quantities over time, as small plots.
#pragma once

#include "render/frame.h"
#include "render/page.h"

namespace render {

// Draws the strips side by side, the last one in the lower right corner. Returns the left end of what was drawn.
float draw_strips(const Page& page, const std::vector<Strip>& strips);

}  // namespace render
