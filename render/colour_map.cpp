#include "render/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>

namespace render {
namespace {

// Colours at even distances from low to high, 0xRRGGBB. viridis, magma, plasma: S. van der Walt and N. Smith (2015),
// public domain; cividis: J. Nunez, C. Anderton, R. Renslow (2018); blue-red: C. Brewer's RdBu.
constexpr std::array<std::uint32_t, 11> viridis = {0x440154, 0x482475, 0x414487, 0x355f8d, 0x2a788e, 0x21918c,
                                                   0x22a884, 0x44bf70, 0x7ad151, 0xbddf26, 0xfde725};
constexpr std::array<std::uint32_t, 10> cividis = {0x00204d, 0x00336f, 0x39486b, 0x575c6d, 0x707173,
                                                   0x8a8779, 0xa69d75, 0xc4b56c, 0xe4cf5b, 0xffea46};
constexpr std::array<std::uint32_t, 11> magma = {0x000004, 0x140e36, 0x3b0f70, 0x641a80, 0x8c2981, 0xb73779,
                                                 0xde4968, 0xf7705c, 0xfe9f6d, 0xfecf92, 0xfcfdbf};
constexpr std::array<std::uint32_t, 11> plasma = {0x0d0887, 0x41049d, 0x6a00a8, 0x8f0da4, 0xb12a90, 0xcc4778,
                                                  0xe16462, 0xf2844b, 0xfca636, 0xfcce25, 0xf0f921};
constexpr std::array<std::uint32_t, 11> blue_red = {0x053061, 0x2166ac, 0x4393c3, 0x92c5de, 0xd1e5f0, 0xf7f7f7,
                                                    0xfddbc7, 0xf4a582, 0xd6604d, 0xb2182b, 0x67001f};

struct NamedMap {
  const char* name;
  std::span<const std::uint32_t> stops;
};

constexpr std::array<NamedMap, 5> maps = {
    {{"viridis", viridis}, {"cividis", cividis}, {"magma", magma}, {"plasma", plasma}, {"blue-red", blue_red}}};

std::span<const std::uint32_t> stops_of(const std::string& name) {
  for (const NamedMap& map : maps) {
    if (name == map.name) return map.stops;
  }
  std::string message = "colour map \"" + name + "\" is not known; known are";
  for (const NamedMap& map : maps) message += std::string(" ") + map.name;
  throw std::invalid_argument(message);
}

float channel(std::uint32_t stop, int k) {
  return static_cast<float>((stop >> (16 - 8 * k)) & 0xffU) / 255;
}

}  // namespace

float to_linear(float srgb) {
  return srgb <= 0.04045F ? srgb / 12.92F : std::pow((srgb + 0.055F) / 1.055F, 2.4F);
}

float to_srgb(float linear) {
  return linear <= 0.0031308F ? linear * 12.92F : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
}

Eigen::Vector3f to_linear(const Colour& srgb) {
  return {to_linear(srgb[0]), to_linear(srgb[1]), to_linear(srgb[2])};
}

std::vector<std::string_view> colour_map_names() {
  std::vector<std::string_view> names;
  for (const NamedMap& map : maps) names.emplace_back(map.name);
  return names;
}

// Catmull-Rom between the stops: p(s) = p1 + s/2 (p2 - p0 + s (2 p0 - 5 p1 + 4 p2 - p3 + s (3 (p1 - p2) + p3 - p0))).
Colour colour_at(const std::string& map, float t) {
  const std::span<const std::uint32_t> stops = stops_of(map);
  const int last = static_cast<int>(stops.size()) - 1;
  const float place = std::clamp(t, 0.0F, 1.0F) * static_cast<float>(last);
  const int left = std::min(static_cast<int>(place), last - 1);
  const float s = place - static_cast<float>(left);
  const auto stop = [&](int i) { return stops[static_cast<std::size_t>(std::clamp(i, 0, last))]; };
  Colour colour{};
  for (int k = 0; k < 3; ++k) {
    const float p0 = channel(stop(left - 1), k), p1 = channel(stop(left), k);
    const float p2 = channel(stop(left + 1), k), p3 = channel(stop(left + 2), k);
    const float cubic = 2 * p0 - 5 * p1 + 4 * p2 - p3 + s * (3 * (p1 - p2) + p3 - p0);
    colour[static_cast<std::size_t>(k)] = std::clamp(p1 + s / 2 * (p2 - p0 + s * cubic), 0.0F, 1.0F);
  }
  return colour;
}

std::vector<std::uint8_t> colour_table(const std::string& map, int size) {
  std::vector<std::uint8_t> table;
  for (int i = 0; i < size; ++i) {
    for (const float c : colour_at(map, static_cast<float>(i) / static_cast<float>(std::max(size - 1, 1)))) {
      table.push_back(static_cast<std::uint8_t>(std::lround(c * 255)));
    }
  }
  return table;
}

}  // namespace render
