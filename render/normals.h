// Vertex normals of a triangulated surface: smooth, but sharp at creases.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace render {

// A surface whose vertices are doubled along creases, so that each copy has one normal. The first n vertices are the
// given ones in their order; copies follow.
struct Smoothing {
  std::vector<std::uint32_t> triangles;  // 3 m: corners, as copies
  std::vector<std::uint32_t> source;     // the given vertex of each copy
};

// Two triangles that share an edge share normals there when their planes differ by less than `crease` degrees.
// positions: 3 n; triangles: 3 m, each below n.
Smoothing smooth_groups(const std::vector<float>& positions, const std::vector<std::uint32_t>& triangles, float crease);

// Whether the triangles leave no hole: along every edge as many pass one way as the other. Such a surface has an inside
// that is not seen.
bool is_closed(const std::vector<std::uint32_t>& triangles);

// Unit normals, one per copy: sum of 2 area * normal over the triangles around it, normalised. Where that vanishes
// (no triangle, or flat to a line) the normal is (0, 0, 1).
void vertex_normals(const Smoothing& smoothing, const std::vector<float>& positions,
                    std::vector<Eigen::Vector3f>& normals);

}  // namespace render
