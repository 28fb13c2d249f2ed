// Surfaces and frames that the renderer's tests draw.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <vector>

#include "render/frame.h"

namespace shapes {

using render::Point;
using render::Surface;

// A lattice of (columns + 1) x (rows + 1) vertices, placed by `at` of (0..1, 0..1); counter-clockwise as u x v. Edges
// are the lattice lines, the outline its border.
inline Surface lattice(int columns, int rows, const std::function<Point(float, float)>& at) {
  Surface surface;
  const auto index = [&](int i, int j) { return static_cast<std::uint32_t>(j * (columns + 1) + i); };
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const Point p = at(static_cast<float>(i) / columns, static_cast<float>(j) / rows);
      surface.positions.insert(surface.positions.end(), p.begin(), p.end());
      const auto line = [&](std::uint32_t other, bool border) {
        surface.edges.insert(surface.edges.end(), {index(i, j), other});
        if (border) surface.outline.insert(surface.outline.end(), {index(i, j), other});
      };
      if (i < columns) line(index(i + 1, j), j == 0 || j == rows);
      if (j < rows) line(index(i, j + 1), i == 0 || i == columns);
      if (i == columns || j == rows) continue;
      const std::uint32_t a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1), d = index(i, j + 1);
      surface.triangles.insert(surface.triangles.end(), {a, b, c, a, c, d});
    }
  }
  return surface;
}

// Appends the other surface.
inline void append(Surface& surface, const Surface& other) {
  const auto first = static_cast<std::uint32_t>(surface.positions.size() / 3);
  surface.positions.insert(surface.positions.end(), other.positions.begin(), other.positions.end());
  surface.values.insert(surface.values.end(), other.values.begin(), other.values.end());
  for (const std::uint32_t v : other.triangles) surface.triangles.push_back(first + v);
  for (const std::uint32_t v : other.edges) surface.edges.push_back(first + v);
}

inline Surface sphere(const Point& centre, float radius, int rows = 40) {
  constexpr float pi = std::numbers::pi_v<float>;
  Surface surface = lattice(2 * rows, rows, [&](float u, float v) {
    const float azimuth = 2 * pi * u, polar = pi * v;
    return Point{centre[0] + radius * std::sin(polar) * std::sin(azimuth), centre[1] - radius * std::cos(polar),
                 centre[2] + radius * std::sin(polar) * std::cos(azimuth)};
  });
  surface.name = "sphere";
  // The seam would show as a crease: normals are given.
  for (std::size_t i = 0; i < surface.positions.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) surface.normals.push_back((surface.positions[i + k] - centre[k]) / radius);
  }
  return surface;
}

// A box [0, size] with `cells` quads along x, bent by `shape`; its six faces are not joined.
inline Surface box(const Point& size, int cells, const std::function<Point(Point)>& shape) {
  Surface surface;
  surface.name = "box";
  const int across = std::max(1, cells / 4);
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool high : {false, true}) {
      const int u = (axis + (high ? 1 : 2)) % 3, v = (axis + (high ? 2 : 1)) % 3;
      append(surface, lattice(u == 0 ? cells : across, v == 0 ? cells : across, [&](float s, float t) {
               Point p{0, 0, 0};
               p[static_cast<std::size_t>(axis)] = high ? size[static_cast<std::size_t>(axis)] : 0;
               p[static_cast<std::size_t>(u)] = s * size[static_cast<std::size_t>(u)];
               p[static_cast<std::size_t>(v)] = t * size[static_cast<std::size_t>(v)];
               return shape(p);
             }));
    }
  }
  return surface;
}

// The zero level of a field in the cube [-1, 1]^3, cells^3: one vertex per cell that the level crosses, at the mean
// of the crossings of its edges, one quad per lattice edge that it crosses.
inline Surface level_set(const std::function<float(const Point&)>& field, int cells) {
  const auto corner = [&](int i, int j, int k) {
    const auto c = [&](int n) { return -1 + 2 * static_cast<float>(n) / static_cast<float>(cells); };
    return Point{c(i), c(j), c(k)};
  };
  const int points = cells + 1;
  std::vector<float> values(static_cast<std::size_t>(points) * points * points);
  const auto at = [&](int i, int j, int k) -> float& {
    return values[static_cast<std::size_t>((k * points + j) * points + i)];
  };
  for (int k = 0; k < points; ++k)
    for (int j = 0; j < points; ++j)
      for (int i = 0; i < points; ++i) at(i, j, k) = field(corner(i, j, k));

  Surface surface;
  std::map<std::array<int, 3>, std::uint32_t> vertices;
  const auto vertex = [&](int i, int j, int k) {
    const auto [place, is_new] = vertices.try_emplace({i, j, k}, static_cast<std::uint32_t>(vertices.size()));
    if (!is_new) return place->second;
    Point sum{0, 0, 0};
    int crossings = 0;
    for (int axis = 0; axis < 3; ++axis) {
      for (int e = 0; e < 4; ++e) {
        std::array<int, 3> a{i, j, k};
        a[static_cast<std::size_t>((axis + 1) % 3)] += e & 1;
        a[static_cast<std::size_t>((axis + 2) % 3)] += e >> 1;
        std::array<int, 3> b = a;
        ++b[static_cast<std::size_t>(axis)];
        const float f = at(a[0], a[1], a[2]), g = at(b[0], b[1], b[2]);
        if ((f < 0) == (g < 0)) continue;
        const Point p = corner(a[0], a[1], a[2]), q = corner(b[0], b[1], b[2]);
        for (std::size_t n = 0; n < 3; ++n) sum[n] += p[n] + f / (f - g) * (q[n] - p[n]);
        ++crossings;
      }
    }
    for (const float c : sum) surface.positions.push_back(c / static_cast<float>(crossings));
    return place->second;
  };
  for (int k = 1; k < cells; ++k)
    for (int j = 1; j < cells; ++j)
      for (int i = 1; i < cells; ++i)
        for (int axis = 0; axis < 3; ++axis) {
          std::array<int, 3> end{i, j, k}, du{0, 0, 0}, dv{0, 0, 0};
          ++end[static_cast<std::size_t>(axis)];
          du[static_cast<std::size_t>((axis + 1) % 3)] = 1;
          dv[static_cast<std::size_t>((axis + 2) % 3)] = 1;
          const float f = at(i, j, k), g = at(end[0], end[1], end[2]);
          if ((f < 0) == (g < 0)) continue;
          std::uint32_t a = vertex(i - du[0] - dv[0], j - du[1] - dv[1], k - du[2] - dv[2]);
          std::uint32_t b = vertex(i - dv[0], j - dv[1], k - dv[2]);
          const std::uint32_t c = vertex(i, j, k);
          std::uint32_t d = vertex(i - du[0], j - du[1], k - du[2]);
          if (f > g) std::swap(b, d);
          surface.triangles.insert(surface.triangles.end(), {a, b, c, a, c, d});
          surface.edges.insert(surface.edges.end(), {a, b, b, c});
        }
  return surface;
}

// A sitting bear of blended balls, feet at y = -0.9.
inline Surface bear(int cells) {
  struct Ball {
    Point centre;
    float radius;
  };
  static constexpr Ball balls[] = {
      {{0, -0.3F, 0}, 0.42F},          {{0, 0.32F, 0.03F}, 0.33F},     {{0, 0.25F, 0.28F}, 0.15F},
      {{0.23F, 0.62F, 0}, 0.12F},      {{-0.23F, 0.62F, 0}, 0.12F},    {{0.42F, -0.08F, 0.2F}, 0.15F},
      {{-0.42F, -0.08F, 0.2F}, 0.15F}, {{0.3F, -0.72F, 0.28F}, 0.18F}, {{-0.3F, -0.72F, 0.28F}, 0.18F}};
  Surface surface = level_set(
      [](const Point& p) {
        // Smooth minimum of the distances: -log(sum exp(-k d)) / k.
        float sum = 0;
        for (const Ball& ball : balls) {
          const float d = std::hypot(p[0] - ball.centre[0], p[1] - ball.centre[1], p[2] - ball.centre[2]);
          sum += std::exp(-24 * (d - ball.radius));
        }
        return -std::log(sum) / 24;
      },
      cells);
  surface.name = "bear";
  return surface;
}

}  // namespace shapes
