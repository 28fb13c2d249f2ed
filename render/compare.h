// How much two pictures differ.
#pragma once

#include "render/image.h"

namespace render {

struct Difference {
  int largest = 0;   // of a channel, 0 to 255
  double share = 0;  // of the pixels of which a channel differs by more than what is tolerated
};

// Of two pictures of the same size; throws std::invalid_argument for others.
Difference compare(const Image& one, const Image& other, int tolerated);

// `one` in pale grey, and on it the pixels that differ: yellow as far as tolerated, red beyond.
Image difference_picture(const Image& one, const Image& other, int tolerated);

}  // namespace render
