// A picture in memory.
#pragma once

#include <cstdint>
#include <vector>

namespace render {

// width x height pixels, four bytes each (red, green, blue, alpha), sRGB, top row first.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

}  // namespace render
