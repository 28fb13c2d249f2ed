// An independent look at whether bodies passed through each other: shares nothing with the program but its lists of
// facets. Tet4 and tri3 only.
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "sim/mesh/boundary.h"
#include "sim/scene.h"

namespace sim::test {

struct SurfaceFacet {
  int body;      // obstacles that are surfaces count on behind the bodies
  int nodes[3];  // of the system; the third is -1 in the plane
};

// Obstacles that are released before t [s] are left out.
inline std::vector<SurfaceFacet> facets_of(const Scene& scene, double t = 0) {
  std::vector<SurfaceFacet> all;
  int first = 0, number = 0;
  const auto add = [&](const Eigen::MatrixXi& own, Eigen::Index nodes, bool is_gone = false) {
    for (Eigen::Index f = 0; f < own.cols() && !is_gone; ++f) {
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
      add(surface->faces, surface->X.cols(), obstacle.release && t > *obstacle.release);
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
  // An edge in the plane of the triangle, but for round-off: of a flat side of one body.
  if (std::abs(M.determinant()) <= 1e-13 * M.colwise().norm().prod()) return false;
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

// How many edges of one facet go through the other.
inline int passing(const SurfaceFacet& of, const SurfaceFacet& through, const Eigen::VectorXd& x, int D) {
  const auto at = [&](const SurfaceFacet& facet, int i) { return place_of(x, facet.nodes[i % D], D); };
  const int* n = through.nodes;
  int count = 0;
  for (int i = 0; i < (D == 2 ? 1 : 3); ++i) {
    const int from = of.nodes[i], to = of.nodes[(i + 1) % D];
    if (std::any_of(n, n + D, [&](int node) { return node == from || node == to; })) continue;
    const Vec3 p = at(of, i), q = at(of, i + 1), a = at(through, 0), b = at(through, 1);
    count += D == 2 ? passes(p, q, a, b) : passes(p, q, a, b, at(through, 2));
  }
  return count;
}

// How many edges of a surface go through a facet, of other bodies or of their own; `own`: those as well. Facets are
// looked at from low to high x, so that only those that overlap in x are tried. What is released by t [s] is left out.
inline int count_crossings(const Scene& scene, const Eigen::VectorXd& x, bool own = true, double t = 0) {
  const int D = scene.dimension;
  struct Boxed {
    SurfaceFacet facet;
    Vec3 low, high;
  };
  std::vector<Boxed> all;
  for (const SurfaceFacet& facet : facets_of(scene, t)) {
    Boxed boxed{facet, place_of(x, facet.nodes[0], D), place_of(x, facet.nodes[0], D)};
    for (int i = 1; i < D; ++i) {
      boxed.low = boxed.low.cwiseMin(place_of(x, facet.nodes[i], D));
      boxed.high = boxed.high.cwiseMax(place_of(x, facet.nodes[i], D));
    }
    all.push_back(boxed);
  }
  std::sort(all.begin(), all.end(), [](const Boxed& a, const Boxed& b) { return a.low.x() < b.low.x(); });
  int count = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size() && all[j].low.x() <= all[i].high.x(); ++j) {
      const Boxed &a = all[i], &b = all[j];
      if ((!own && a.facet.body == b.facet.body) || (a.low.array() > b.high.array()).any() ||
          (b.low.array() > a.high.array()).any())
        continue;
      count += passing(a.facet, b.facet, x, D) + (D == 2 ? 0 : passing(b.facet, a.facet, x, D));
    }
  return count;
}

// Whether a ball reaches into an edge or a triangle: by the quadratics of its edges, and by the foot on its plane.
inline bool reaches(const Vec3& centre, double radius, const Vec3& a, const Vec3& b) {
  const Vec3 u = b - a, w = a - centre;
  const double B = 2 * u.dot(w), C = w.squaredNorm() - radius * radius, A = u.squaredNorm();
  const double foot = -B / (2 * A);
  return C < 0 || A + B + C < 0 || (foot > 0 && foot < 1 && B * B > 4 * A * C);
}
inline bool reaches(const Vec3& centre, double radius, const Vec3& a, const Vec3& b, const Vec3& c) {
  if (reaches(centre, radius, a, b) || reaches(centre, radius, b, c) || reaches(centre, radius, c, a)) return true;
  const Vec3 n = (b - a).cross(c - a), foot = centre - n.dot(centre - a) / n.squaredNorm() * n;
  const bool inside =
      n.dot((b - a).cross(foot - a)) > 0 && n.dot((c - b).cross(foot - b)) > 0 && n.dot((a - c).cross(foot - c)) > 0;
  return inside && (foot - centre).norm() < radius;
}

// How many facets of bodies reach into an obstacle that is a sphere.
inline int count_entered(const Scene& scene, const Eigen::VectorXd& x) {
  const int D = scene.dimension;
  int node = 0, count = 0;
  for (const Body& body : scene.bodies) node += static_cast<int>(body.mesh.node_count());
  for (const Obstacle& obstacle : scene.obstacles) {
    if (const auto* sphere = std::get_if<Sphere>(&obstacle.shape)) {
      const Vec3 centre = obstacle.motion.empty() ? sphere->centre : place_of(x, node, D);
      for (const SurfaceFacet& facet : facets_of(scene)) {
        if (facet.body >= static_cast<int>(scene.bodies.size())) continue;
        const int* n = facet.nodes;
        const Vec3 a = place_of(x, n[0], D), b = place_of(x, n[1], D);
        count += D == 2 ? reaches(centre, sphere->radius, a, b)
                        : reaches(centre, sphere->radius, a, b, place_of(x, n[2], D));
      }
    }
    if (const auto* surface = std::get_if<RigidSurface>(&obstacle.shape))
      node += static_cast<int>(surface->X.cols());
    else if (!obstacle.motion.empty())
      node += std::holds_alternative<Plane>(obstacle.shape) ? 2 : 1;
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
