#include "render/normals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace render {
namespace {

Eigen::Vector3f vertex(const std::vector<float>& positions, std::uint32_t v) {
  return Eigen::Map<const Eigen::Vector3f>(positions.data() + 3 * static_cast<std::size_t>(v));
}

// (b - a) x (c - a): twice the area, along the normal.
Eigen::Vector3f area_normal(const std::vector<float>& positions, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const Eigen::Vector3f origin = vertex(positions, a);
  return (vertex(positions, b) - origin).cross(vertex(positions, c) - origin);
}

// The corners around each vertex: those of vertex v are corners[first[v]] ... corners[first[v + 1] - 1].
struct Fans {
  std::vector<std::uint32_t> first, corners;
};

Fans fans_of(const std::vector<std::uint32_t>& triangles, std::size_t vertices) {
  Fans fans{std::vector<std::uint32_t>(vertices + 1, 0), std::vector<std::uint32_t>(triangles.size())};
  for (const std::uint32_t v : triangles) ++fans.first[v + 1];
  std::partial_sum(fans.first.begin(), fans.first.end(), fans.first.begin());
  std::vector<std::uint32_t> next(fans.first.begin(), fans.first.end() - 1);
  for (std::uint32_t corner = 0; corner < triangles.size(); ++corner) fans.corners[next[triangles[corner]]++] = corner;
  return fans;
}

// A triangle's edge that leaves the vertex of a fan: the vertex at its other end, and the corner (place in the fan).
struct Spoke {
  std::uint32_t end, place;
};

std::uint32_t root(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

// Joins the corners of one fan across the spokes that are no creases; parent is a forest over places in the fan.
void join_fan(const std::uint32_t* corners, const std::vector<std::uint32_t>& triangles,
              const std::vector<Eigen::Vector3f>& face_normals, float cosine, std::vector<Spoke>& spokes,
              std::vector<std::uint32_t>& parent) {
  spokes.clear();
  for (std::uint32_t place = 0; place < parent.size(); ++place) {
    const std::uint32_t face = corners[place] / 3, corner = corners[place] % 3;
    spokes.push_back({triangles[3 * face + (corner + 1) % 3], place});
    spokes.push_back({triangles[3 * face + (corner + 2) % 3], place});
  }
  std::sort(spokes.begin(), spokes.end(),
            [](const Spoke& a, const Spoke& b) { return a.end != b.end ? a.end < b.end : a.place < b.place; });
  for (std::size_t i = 1; i < spokes.size(); ++i) {
    if (spokes[i].end != spokes[i - 1].end) continue;
    const Eigen::Vector3f& one = face_normals[corners[spokes[i - 1].place] / 3];
    const Eigen::Vector3f& other = face_normals[corners[spokes[i].place] / 3];
    if (one.dot(other) < cosine && !one.isZero() && !other.isZero()) continue;
    parent[root(parent, spokes[i].place)] = root(parent, spokes[i - 1].place);
  }
}

}  // namespace

Smoothing smooth_groups(const std::vector<float>& positions, const std::vector<std::uint32_t>& triangles,
                        float crease) {
  const std::size_t vertices = positions.size() / 3;
  const float cosine = std::cos(crease * std::numbers::pi_v<float> / 180);
  std::vector<Eigen::Vector3f> face_normals(triangles.size() / 3);
  for (std::size_t f = 0; f < face_normals.size(); ++f) {
    face_normals[f] = area_normal(positions, triangles[3 * f], triangles[3 * f + 1], triangles[3 * f + 2]);
    face_normals[f].stableNormalize();
  }
  Smoothing result{triangles, std::vector<std::uint32_t>(vertices)};
  std::iota(result.source.begin(), result.source.end(), 0U);
  const Fans fans = fans_of(triangles, vertices);
  std::vector<Spoke> spokes;
  std::vector<std::uint32_t> parent, copy_of_root;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const std::uint32_t* corners = fans.corners.data() + fans.first[v];
    parent.resize(fans.first[v + 1] - fans.first[v]);
    std::iota(parent.begin(), parent.end(), 0U);
    join_fan(corners, triangles, face_normals, cosine, spokes, parent);
    // The first group keeps the vertex, every other one gets a copy.
    constexpr std::uint32_t none = 0xffffffffU;
    copy_of_root.assign(parent.size(), none);
    bool kept = false;
    for (std::uint32_t place = 0; place < parent.size(); ++place) {
      std::uint32_t& copy = copy_of_root[root(parent, place)];
      if (copy == none) {
        copy = kept ? static_cast<std::uint32_t>(result.source.size()) : v;
        if (kept) result.source.push_back(v);
        kept = true;
      }
      result.triangles[corners[place]] = copy;
    }
  }
  return result;
}

bool is_closed(const std::vector<std::uint32_t>& triangles) {
  // Each edge of each triangle, with the sense in which it is passed; around a hole the senses do not cancel.
  struct Edge {
    std::uint32_t low, high;
    int sense;
  };
  std::vector<Edge> edges;
  edges.reserve(triangles.size());
  for (std::size_t k = 0; k + 2 < triangles.size(); k += 3) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = triangles[k + i], b = triangles[k + (i + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
  int balance = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    balance += edges[i].sense;
    const bool last = i + 1 == edges.size() || edges[i].low != edges[i + 1].low || edges[i].high != edges[i + 1].high;
    if (last && balance != 0) return false;
  }
  return true;
}

void vertex_normals(const Smoothing& smoothing, const std::vector<float>& positions,
                    std::vector<Eigen::Vector3f>& normals) {
  normals.assign(smoothing.source.size(), Eigen::Vector3f::Zero());
  for (std::size_t k = 0; k + 2 < smoothing.triangles.size(); k += 3) {
    const std::uint32_t* t = smoothing.triangles.data() + k;
    const Eigen::Vector3f normal =
        area_normal(positions, smoothing.source[t[0]], smoothing.source[t[1]], smoothing.source[t[2]]);
    for (int i = 0; i < 3; ++i) normals[t[i]] += normal;
  }
  for (Eigen::Vector3f& normal : normals) {
    const float length = normal.stableNorm();
    normal = length > 0 ? Eigen::Vector3f(normal / length) : Eigen::Vector3f::UnitZ();
  }
}

}  // namespace render
