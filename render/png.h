// Pictures as PNG files in memory.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "render/image.h"

namespace render {

// The bytes of a PNG file: RGB where every pixel is opaque, RGBA otherwise. Safe to call from several threads. Throws
// std::invalid_argument when the size and the bytes of the image do not match, std::runtime_error when encoding fails.
std::vector<std::uint8_t> encode_png(const Image& image);

// The picture of a PNG file; what is not transparent has opacity 255. Throws std::invalid_argument for other bytes.
Image decode_png(std::string_view bytes);

}  // namespace render
