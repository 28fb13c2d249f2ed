// Scenes of bodies that touch, and an independent look at whether surfaces cross: for the tests of contact.
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <string>

#include "sim/mesh/boundary.h"
#include "sim/mesh/transform.h"
#include "tests/sim/scenes.h"

namespace sim::test {

// A box of cells^3 cells with its low corner at `low`.
inline Body box_body(const std::string& name, const Vec3& size, int cells, const Vec3& low, double young = 1e5,
                     ElementKind kind = ElementKind::tet4) {
  Body body;
  body.name = name;
  body.mesh = generate_box({size[0], size[1], size[2]}, {cells, cells, cells}, {1, 1, 1}, kind);
  translate(body.mesh, low);
  body.materials = {MaterialSpec{"stable-neo-hookean", young, 0.4, 1000, ""}};
  return body;
}

// Two boxes of 1 m, one falls from `height` above the other, which is held at its foot.
inline Scene two_boxes(int cells, double height, ElementKind kind = ElementKind::tet4) {
  Scene scene;
  scene.bodies = {box_body("low", {1, 1, 1}, cells, {0, 0, 0}, 1e5, kind),
                  box_body("top", {1, 1, 1}, cells, {0.13, 1 + height, 0.07}, 1e5, kind)};
  scene.bodies[0].pins = {Pin{Box{{-1, -1e-6, -1}, {2, 1e-6, 2}}, "xyz", {}, {}}};
  scene.contacts = {Contact{}};
  return scene;
}

// How many edges of a surface go through a facet: of other bodies or of their own, by solving for the place on both.
// Tet4 and tri3 only; in the plane, edges that cross. Shares nothing with the program.
inline int count_crossings(const Scene& scene, const Eigen::VectorXd& x) {
  const int D = scene.dimension;
  struct Facet {
    int nodes[3];
  };
  std::vector<Facet> facets, edges;
  int first = 0;
  for (const Body& body : scene.bodies) {
    const Eigen::MatrixXi own = D == 2 ? boundary_facets(body.mesh) : surface_facets(body.mesh);
    for (Eigen::Index f = 0; f < own.cols(); ++f) {
      Facet facet{{-1, -1, -1}};
      for (int i = 0; i < D; ++i) facet.nodes[i] = first + own(i, f);
      facets.push_back(facet);
      for (int i = 0; i < (D == 2 ? 1 : 3); ++i)
        if (D == 2 || facet.nodes[i] < facet.nodes[(i + 1) % 3])
          edges.push_back({{facet.nodes[i], facet.nodes[(i + 1) % D], -1}});
    }
    first += body.mesh.node_count();
  }
  const auto at = [&](int node) {
    Vec3 y = Vec3::Zero();
    y.head(D) = x.segment(static_cast<Eigen::Index>(node) * D, D);
    return y;
  };
  int count = 0;
  for (const Facet& edge : edges)
    for (const Facet& facet : facets) {
      bool shared = false;
      for (const int a : {edge.nodes[0], edge.nodes[1]})
        for (const int b : facet.nodes) shared = shared || a == b;
      if (shared) continue;
      const Vec3 p = at(edge.nodes[0]), q = at(edge.nodes[1]), a = at(facet.nodes[0]), b = at(facet.nodes[1]);
      const Vec3 low = p.cwiseMin(q), high = p.cwiseMax(q);
      if (D == 2) {
        Eigen::Matrix2d M;
        M << (q - p).head<2>(), (a - b).head<2>();
        const Eigen::Vector2d st = M.fullPivLu().solve((a - p).head<2>());
        count += M.determinant() != 0 && st.minCoeff() > 0 && st.maxCoeff() < 1;
        continue;
      }
      const Vec3 c = at(facet.nodes[2]);
      if ((a.cwiseMax(b).cwiseMax(c) - low).minCoeff() < 0 || (high - a.cwiseMin(b).cwiseMin(c)).minCoeff() < 0)
        continue;
      Eigen::Matrix3d M;
      M << q - p, a - b, a - c;
      if (M.determinant() == 0) continue;
      const Vec3 s = M.inverse() * (a - p);
      count += s[0] > 0 && s[0] < 1 && s[1] > 0 && s[2] > 0 && s[1] + s[2] < 1;
    }
  return count;
}

}  // namespace sim::test
