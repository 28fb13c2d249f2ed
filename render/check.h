// Whether a frame can be drawn.
#pragma once

#include "render/frame.h"

namespace render {

// Throws std::invalid_argument naming the surface (or other part) and what is wrong with it: numbers that are not
// finite, indices out of range, lists of wrong length, values without a scale.
void check(const Frame& frame);

}  // namespace render
