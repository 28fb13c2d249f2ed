// Planes that are seen edge-on, as figures draw them.
#pragma once

#include "render/frame.h"
#include "render/page.h"
#include "render/view.h"

namespace render {

// A line across the picture for each plane that holds the direction of an orthographic view, hatched on its solid side.
void draw_hatched_planes(const Page& page, const Frame& frame, const View& view);

}  // namespace render
