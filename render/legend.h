// The colour scale as a bar with numbers.
#pragma once

#include "render/frame.h"
#include "render/page.h"

namespace render {

// Draws at the right edge, centred in height, but not below `bottom` (pixels from above). Returns its upper left
// corner.
ImVec2 draw_legend(const Page& page, const ColourScale& scale, float bottom);

}  // namespace render
