// Coarse surfaces made round for the eye: every triangle is split in four, and middles of edges are lifted to where the
// normals at both ends want them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "render/normals.h"

namespace render {

// One level: middle i becomes vertex n + i of the finer surface, n being the vertices of the coarser one.
struct Rounding {
  struct Middle {
    std::uint32_t a, b;  // the ends of its edge
    bool curved;         // two triangles share the edge and its normals; creases and borders stay straight
  };
  std::vector<Middle> middles;
  std::vector<std::uint32_t> triangles;  // of the finer surface
};

// As many levels as pay: none where triangles are many (and so small on the screen). `edges`, pairs of given vertices,
// become the pairs along the finer edges.
std::vector<Rounding> rounding_of(const Smoothing& smoothing, std::vector<std::uint32_t>& edges);

// Appends the middles' positions, unit normals and values. At an edge from a to b with unit normals n_a, n_b the cubic
// of a PN triangle [Vlachos et al. 2001] passes through
//   (a + b)/2 - ((b - a).n_a n_a + (a - b).n_b n_b)/8
void add_middles(const Rounding& level, std::vector<Eigen::Vector3f>& positions, std::vector<Eigen::Vector3f>& normals,
                 std::vector<float>& values);

}  // namespace render
