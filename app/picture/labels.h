// Where the names of bodies stand in a picture.
#pragma once

#include <cstddef>

#include "render/frame.h"

namespace app {

// A label for each of the first `count` surfaces of the frame: above the point that is highest on the screen, in the
// middle of the body; below it, where another body is in front of that place, or in the plane beside it, and would seem
// to be named.
void add_labels(std::size_t count, render::Frame& frame);

}  // namespace app
