// Surfaces that a solid may be made of.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "sim/mesh/boundary.h"
#include "sim/mesh/check.h"
#include "sim/mesh/generate.h"
#include "sim/mesh/refine.h"

namespace sim::test {

inline Mesh surface_of(const Eigen::Matrix3Xd& X, const Eigen::Matrix3Xi& triangles) {
  Mesh mesh;
  mesh.kind = ElementKind::tri3;
  mesh.X = X;
  mesh.elements = triangles;
  return mesh;
}

// 20 triangles split `times` times, on a sphere.
inline Mesh ball(double radius, const Vec3& centre = Vec3::Zero(), int times = 3) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  Mesh mesh;
  mesh.kind = ElementKind::tri3;
  mesh.X.resize(3, 12);
  mesh.X << -1, 1, -1, 1, 0, 0, 0, 0, g, g, -g, -g, g, g, -g, -g, -1, 1, -1, 1, 0, 0, 0, 0, 0, 0, 0, 0, g, g, -g, -g,
      -1, 1, -1, 1;
  mesh.elements.resize(3, 20);
  mesh.elements << 0, 0, 0, 0, 0, 1, 5, 11, 10, 7, 3, 3, 3, 3, 3, 4, 2, 6, 8, 9, 11, 5, 1, 7, 10, 5, 11, 10, 7, 1, 9, 4,
      2, 6, 8, 9, 4, 2, 6, 8, 5, 1, 7, 10, 11, 9, 4, 2, 6, 8, 4, 2, 6, 8, 9, 5, 11, 10, 7, 1;
  for (int k = 0; k < times; ++k) mesh = refine(mesh);
  for (auto x : mesh.X.colwise()) x = (centre + radius * Vec3(x).normalized()).eval();
  return mesh;
}

inline Mesh block_surface(const Vec3& lengths, const Vec3& corner = Vec3::Zero()) {
  const Mesh solid = generate_box(lengths, {4, 4, 4}, {1, 1, 1}, ElementKind::tet4);
  Mesh mesh = surface_of(solid.X.colwise() + corner, boundary_facets(solid));
  check_and_orient(mesh);
  return mesh;
}

inline Mesh joined(const Mesh& a, const Mesh& b) {
  Mesh mesh = a;
  mesh.X.resize(3, a.X.cols() + b.X.cols());
  mesh.X << a.X, b.X;
  mesh.elements.resize(3, a.elements.cols() + b.elements.cols());
  mesh.elements << a.elements, (b.elements.array() + a.node_count()).matrix();
  return mesh;
}

inline Mesh without_triangles(Mesh mesh, int from, int count) {
  std::vector<int> kept;
  for (int t = 0; t < mesh.element_count(); ++t)
    if (t < from || t >= from + count) kept.push_back(t);
  mesh.elements = Eigen::MatrixXi(mesh.elements(Eigen::indexing::all, kept));
  return mesh;
}

inline void turn_over(Mesh& mesh, int from, int count) {
  for (int t = from; t < from + count; ++t) std::swap(mesh.elements(0, t), mesh.elements(1, t));
}

}  // namespace sim::test
