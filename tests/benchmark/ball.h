// A surface of any number of triangles.
#pragma once

#include <cmath>

#include "render/frame.h"

namespace benchmarks {

// A ball of about 2 n^2 triangles, of radius 1, that stands on y = 0.
inline render::Surface ball(int n) {
  render::Surface surface;
  surface.name = "ball";
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < n; ++j) {
      const double polar = 3.14159265 * i / n, round = 2 * 3.14159265 * j / n;
      for (const double c : {std::sin(polar) * std::cos(round), 1 + std::cos(polar), std::sin(polar) * std::sin(round)})
        surface.positions.push_back(static_cast<float>(c));
    }
  const auto at = [n](int i, int j) { return static_cast<std::uint32_t>(i * n + j % n); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (const std::uint32_t v : {at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)})
        surface.triangles.push_back(v);
  return surface;
}

}  // namespace benchmarks
