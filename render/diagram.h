// Draws the diagrams of a sheet.
#pragma once

#include "render/page.h"
#include "render/sheet.h"

namespace render {

// The colour of an ink for a draw list.
ImU32 colour_of(Ink ink);
// Width of a line in pixels: 3 at a height of 720.
float line_width(const Page& page);

void draw_diagram(const Page& page, const Diagram& diagram);

}  // namespace render
