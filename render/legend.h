// The colour scale as a bar with numbers.
#pragma once

#include "render/frame.h"
#include "render/page.h"

namespace render {

// Draws at the right edge, centred in height.
void draw_legend(const Page& page, const ColourScale& scale);

}  // namespace render
