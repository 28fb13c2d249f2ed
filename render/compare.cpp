#include "render/compare.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace render {
namespace {

std::string size_text(const Image& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

void check_sizes(const Image& one, const Image& other) {
  if (one.width == other.width && one.height == other.height && one.rgba.size() == other.rgba.size()) return;
  throw std::invalid_argument("pictures of " + size_text(one) + " and " + size_text(other) + " cannot be compared");
}

// The largest difference of a channel of the pixel that begins at `at`.
int channel_difference(const Image& one, const Image& other, std::size_t at) {
  int most = 0;
  for (std::size_t c = at; c < at + 4; ++c) most = std::max(most, std::abs(int{one.rgba[c]} - int{other.rgba[c]}));
  return most;
}

}  // namespace

Difference compare(const Image& one, const Image& other, int tolerated) {
  check_sizes(one, other);
  Difference result;
  std::size_t differing = 0;
  for (std::size_t at = 0; at < one.rgba.size(); at += 4) {
    const int difference = channel_difference(one, other, at);
    result.largest = std::max(result.largest, difference);
    differing += difference > tolerated ? 1 : 0;
  }
  if (!one.rgba.empty()) result.share = static_cast<double>(differing) / static_cast<double>(one.rgba.size() / 4);
  return result;
}

Image difference_picture(const Image& one, const Image& other, int tolerated) {
  check_sizes(one, other);
  Image picture = one;
  for (std::size_t at = 0; at < one.rgba.size(); at += 4) {
    const int difference = channel_difference(one, other, at);
    const int grey = (2 * one.rgba[at] + 5 * one.rgba[at + 1] + one.rgba[at + 2]) / 8;
    const auto pale = static_cast<std::uint8_t>(170 + grey / 3);
    std::uint8_t* pixel = picture.rgba.data() + at;
    std::fill(pixel, pixel + 3, pale);
    if (difference > tolerated) {
      pixel[0] = 200, pixel[1] = 20, pixel[2] = 40;
    } else if (difference > 0) {
      pixel[0] = 235, pixel[1] = 200, pixel[2] = 70;
    }
    pixel[3] = 255;
  }
  return picture;
}

}  // namespace render
