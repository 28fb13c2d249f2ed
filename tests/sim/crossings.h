// An independent look at whether bodies passed through each other: shares nothing with the program but its lists of
// facets. Tet4 and tri3 only.
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "sim/mesh/boundary.h"
#include "sim/scene.h"

namespace sim::test {

struct SurfaceFacet {
  int body;      // obstacles that are surfaces count on behind the bodies
  int nodes[3];  // of the system; the third is -1 in the plane
};

inline std::vector<SurfaceFacet> facets_of(const Scene& scene) {
  std::vector<SurfaceFacet> all;
  int first = 0, number = 0;
  const auto add = [&](const Eigen::MatrixXi& own, Eigen::Index nodes) {
    for (Eigen::Index f = 0; f < own.cols(); ++f) {
      SurfaceFacet facet{number, {-1, -1, -1}};
      for (int i = 0; i < scene.dimension; ++i) facet.nodes[i] = first + own(i, f);
      all.push_back(facet);
    }
    first += static_cast<int>(nodes);
    ++number;
  };
  for (const Body& body : scene.bodies)
    add(scene.dimension == 2 ? boundary_facets(body.mesh) : surface_facets(body.mesh), body.mesh.node_count());
  // Of what moves, a plane has two nodes and a sphere one.
  for (const Obstacle& obstacle : scene.obstacles)
    if (const auto* surface = std::get_if<RigidSurface>(&obstacle.shape))
      add(surface->faces, surface->X.cols());
    else if (!obstacle.motion.empty())
      first += std::holds_alternative<Plane>(obstacle.shape) ? 2 : 1;
  return all;
}

inline Vec3 place_of(const Eigen::VectorXd& x, int node, int D) {
  Vec3 y = Vec3::Zero();
  y.head(D) = x.segment(static_cast<Eigen::Index>(node) * D, D);
  return y;
}

// Whether an edge goes through a triangle: by solving for the place on both.
inline bool passes(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 low = p.cwiseMin(q), high = p.cwiseMax(q);
  if ((a.cwiseMax(b).cwiseMax(c) - low).minCoeff() < 0 || (high - a.cwiseMin(b).cwiseMin(c)).minCoeff() < 0)
    return false;
  Eigen::Matrix3d M;
  M << q - p, a - b, a - c;
  if (M.determinant() == 0) return false;
  const Vec3 s = M.inverse() * (a - p);
  return s[0] > 0 && s[0] < 1 && s[1] > 0 && s[2] > 0 && s[1] + s[2] < 1;
}
// In the plane, whether two edges cross.
inline bool passes(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
  Eigen::Matrix2d M;
  M << (q - p).head<2>(), (a - b).head<2>();
  if (M.determinant() == 0) return false;
  const Eigen::Vector2d s = M.inverse() * (a - p).head<2>();
  return s.minCoeff() > 0 && s.maxCoeff() < 1;
}

// How many edges of a surface go through a facet, of other bodies or of their own; `own`: those as well.
inline int count_crossings(const Scene& scene, const Eigen::VectorXd& x, bool own = true) {
  const int D = scene.dimension;
  const std::vector<SurfaceFacet> facets = facets_of(scene);
  const auto at = [&](int node) { return place_of(x, node, D); };
  int count = 0;
  for (const SurfaceFacet& of : facets)
    for (int i = 0; i < (D == 2 ? 1 : 3); ++i) {
      const int from = of.nodes[i], to = of.nodes[(i + 1) % D];
      if (D == 3 && from > to) continue;  // the facet on its other side has it
      for (const SurfaceFacet& facet : facets) {
        if (!own && facet.body == of.body) continue;
        const int *n = facet.nodes, shared = (n[0] == from) + (n[1] == from) + (n[2] == from) + (n[0] == to) +
                                             (n[1] == to) + (n[2] == to);
        if (shared > 0) continue;
        count += D == 2 ? passes(at(from), at(to), at(n[0]), at(n[1]))
                        : passes(at(from), at(to), at(n[0]), at(n[1]), at(n[2]));
      }
    }
  return count;
}

// How often the surface of a body winds around a point: 1 inside it, 0 outside. It cannot change while no surface
// passes through the point, whatever happens to the body, so that it also tells of what passed between two looks.
inline double winding(const std::vector<SurfaceFacet>& facets, int body, const Eigen::VectorXd& x, int D,
                      const Vec3& point) {
  double angle = 0;  // 4 pi, in the plane 2 pi, for each turn [van Oosterom and Strackee 1983]
  for (const SurfaceFacet& facet : facets) {
    if (facet.body != body) continue;
    const Vec3 a = place_of(x, facet.nodes[0], D) - point, b = place_of(x, facet.nodes[1], D) - point;
    if (D == 2) {
      angle += 2 * std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
      continue;
    }
    const Vec3 c = place_of(x, facet.nodes[2], D) - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4 * 3.14159265358979323846);
}

// Nodes of surfaces that are inside another body.
inline int count_swallowed(const Scene& scene, const Eigen::VectorXd& x) {
  const std::vector<SurfaceFacet> facets = facets_of(scene);
  int count = 0;
  for (const SurfaceFacet& facet : facets)
    for (int b = 0; b < static_cast<int>(scene.bodies.size()); ++b)
      if (b != facet.body)
        count += std::abs(winding(facets, b, x, scene.dimension, place_of(x, facet.nodes[0], scene.dimension))) > 0.5;
  return count;
}

}  // namespace sim::test
