#include "render/rounding.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace render {
namespace {

constexpr std::size_t split_twice_below = 3000,
                      split_once_below = 9000;  // up to so many triangles are split twice, or once

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

// Middles by their ends, with the number of triangles that share the edge.
struct Middles {
  struct Entry {
    std::uint32_t index;
    int triangles;
  };
  std::unordered_map<std::uint64_t, Entry> by_ends;

  std::uint32_t add(Rounding& level, std::uint32_t a, std::uint32_t b) {
    const auto [place, is_new] =
        by_ends.try_emplace(key_of(a, b), Entry{static_cast<std::uint32_t>(level.middles.size()), 0});
    if (is_new) level.middles.push_back({a, b, false});
    level.middles[place->second.index].curved = ++place->second.triangles == 2;
    return place->second.index;
  }
};

Rounding split(const std::vector<std::uint32_t>& triangles, std::uint32_t vertices, Middles& middles) {
  Rounding level;
  for (std::size_t k = 0; k + 2 < triangles.size(); k += 3) {
    const std::uint32_t a = triangles[k], b = triangles[k + 1], c = triangles[k + 2];
    const std::uint32_t ab = vertices + middles.add(level, a, b), bc = vertices + middles.add(level, b, c),
                        ca = vertices + middles.add(level, c, a);
    for (const std::uint32_t v : {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca}) level.triangles.push_back(v);
  }
  return level;
}

// Pairs of given vertices as pairs of the copies that triangles have there.
void find_copies(const Smoothing& smoothing, std::vector<std::uint32_t>& edges) {
  std::unordered_map<std::uint64_t, std::array<std::uint32_t, 2>> copies;
  const std::vector<std::uint32_t>& t = smoothing.triangles;
  for (std::size_t k = 0; k < t.size(); ++k) {
    const std::uint32_t a = t[k], b = t[k % 3 == 2 ? k - 2 : k + 1];
    copies.try_emplace(key_of(smoothing.source[a], smoothing.source[b]), std::array{a, b});
  }
  for (std::size_t k = 0; k + 1 < edges.size(); k += 2) {
    const auto found = copies.find(key_of(edges[k], edges[k + 1]));
    if (found != copies.end()) std::copy(found->second.begin(), found->second.end(), edges.begin() + std::ptrdiff_t(k));
  }
}

void split_edges(const Middles& middles, std::uint32_t vertices, std::vector<std::uint32_t>& edges) {
  std::vector<std::uint32_t> finer;
  for (std::size_t k = 0; k + 1 < edges.size(); k += 2) {
    const auto found = middles.by_ends.find(key_of(edges[k], edges[k + 1]));
    if (found == middles.by_ends.end()) {
      finer.insert(finer.end(), {edges[k], edges[k + 1]});
    } else {
      const std::uint32_t middle = vertices + found->second.index;
      finer.insert(finer.end(), {edges[k], middle, middle, edges[k + 1]});
    }
  }
  edges = std::move(finer);
}

}  // namespace

std::vector<Rounding> rounding_of(const Smoothing& smoothing, std::vector<std::uint32_t>& edges) {
  const std::size_t count = smoothing.triangles.size() / 3;
  const int wanted = count <= split_twice_below ? 2 : count <= split_once_below ? 1 : 0;
  std::vector<Rounding> levels;
  auto vertices = static_cast<std::uint32_t>(smoothing.source.size());
  if (wanted > 0) find_copies(smoothing, edges);
  for (int i = 0; i < wanted; ++i) {
    Middles middles;
    levels.push_back(split(i == 0 ? smoothing.triangles : levels.back().triangles, vertices, middles));
    split_edges(middles, vertices, edges);
    vertices += static_cast<std::uint32_t>(levels.back().middles.size());
  }
  return levels;
}

void add_middles(const Rounding& level, std::vector<Eigen::Vector3f>& positions, std::vector<Eigen::Vector3f>& normals,
                 std::vector<float>& values) {
  for (const Rounding::Middle& middle : level.middles) {
    const Eigen::Vector3f a = positions[middle.a], b = positions[middle.b];
    const Eigen::Vector3f n_a = normals[middle.a], n_b = normals[middle.b];
    Eigen::Vector3f place = (a + b) / 2;
    if (middle.curved) place -= ((b - a).dot(n_a) * n_a + (a - b).dot(n_b) * n_b) / 8;
    const Eigen::Vector3f sum = n_a + n_b;
    const float length = sum.norm();
    positions.push_back(place);
    normals.push_back(length > 1e-3F ? Eigen::Vector3f(sum / length) : n_a);
    values.push_back((values[middle.a] + values[middle.b]) / 2);
  }
}

}  // namespace render
