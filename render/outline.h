// The outlines of flat bodies, as thin smooth lines.
#pragma once

#include "render/frame.h"
#include "render/page.h"
#include "render/view.h"

namespace render {

// Draws the outline of every flat surface, and of every ghost that has one.
void draw_outlines(const Page& page, const Frame& frame, const View& view);

}  // namespace render
