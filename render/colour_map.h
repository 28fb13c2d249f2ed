// Colours: the sRGB curve, and maps from a number to a colour.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "render/frame.h"

namespace render {

// sRGB component (0 to 1) to linear light and back: IEC 61966-2-1.
float to_linear(float srgb);
float to_srgb(float linear);
Eigen::Vector3f to_linear(const Colour& srgb);

// viridis, cividis, magma, plasma: lightness rises evenly, told apart by the colour-blind.
// blue-red: for signed values, light in the middle.
std::vector<std::string_view> colour_map_names();

// The colour at t, 0 (low) to 1 (high), clamped. Throws std::invalid_argument for a name that is not in the list.
Colour colour_at(const std::string& map, float t);

// `size` colours from low to high, three bytes each, sRGB.
std::vector<std::uint8_t> colour_table(const std::string& map, int size);

}  // namespace render
