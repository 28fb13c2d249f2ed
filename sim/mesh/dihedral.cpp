#include "sim/mesh/dihedral.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim {

// At the edge between corners a and b the other two, seen along it, are the angle apart.
double smallest_dihedral(const std::array<Vec3, 4>& corners) {
  constexpr std::array<std::array<int, 4>, 6> edges = {
      {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}};
  double smallest = std::numbers::pi;
  for (const auto& [a, b, c, d] : edges) {
    const Vec3 edge = (corners[b] - corners[a]).normalized();
    const auto across = [&](int corner) {
      const Vec3 arm = corners[corner] - corners[a];
      return Vec3(arm - arm.dot(edge) * edge);
    };
    const Vec3 p = across(c), q = across(d);
    smallest = std::min(smallest, std::atan2(p.cross(q).norm(), p.dot(q)));
  }
  return smallest * 180 / std::numbers::pi;
}

double smallest_dihedral(const Mesh& mesh) {
  double smallest = 180;
  for (const auto& nodes : mesh.elements.colwise()) {
    const auto corner = [&](int i) { return Vec3(mesh.X.col(nodes[i])); };
    smallest = std::min(smallest, smallest_dihedral({corner(0), corner(1), corner(2), corner(3)}));
  }
  return smallest;
}

}  // namespace sim
