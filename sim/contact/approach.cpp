#include "sim/contact/approach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/contact/pair_tangent.h"
#include "sim/contact/spread.h"
#include "sim/contact/step_limit.h"

namespace sim {

namespace {

constexpr double none = std::numeric_limits<double>::infinity();

PairKind kind_of(const Patch& at) {
  return at.count == 2 ? PairKind::point_edge : PairKind::point_triangle;
}

// The centre, and then the nodes.
struct WithCentre {
  WithCentre(const Sphere& sphere, const Patch& at) : x{sphere.centre} { std::copy(at.x, at.x + at.count, x + 1); }
  Vec3 x[4];
};

// The distance of the centre from the patch, by the nodes that carry it.
struct CentreDistance {
  CentreDistance(const WithCentre& pair, const Patch& at) : nearest(sim::nearest(kind_of(at), pair.x)) {
    for (int i = 0; i < node_count(nearest.feature); ++i) x[i] = pair.x[nearest.node[i]];
  }
  Nearest nearest;
  Vec3 x[4];
};

// The least a > 0 at which c + b a + q a^2 = 0, infinity where there is none; c > 0.
double first_root(double c, double b, double q) {
  const double discriminant = b * b - 4 * q * c;
  if (discriminant < 0) return none;
  const double root = std::sqrt(discriminant);
  if (b < 0) return 2 * c / (root - b);
  return q < 0 ? (b + root) / (-2 * q) : none;
}

}  // namespace

double gap(const Plane& plane, const Patch& at) {
  return plane.normal.normalized().dot(at.x[0] - plane.point);
}
double gap(const Sphere& sphere, const Patch& at) {
  return nearest(kind_of(at), WithCentre(sphere, at).x).d - sphere.radius;
}

Approach::Approach(const Plane& plane, const Patch& at)
    : d(gap(plane, at)), normal(plane.normal.normalized()), c{-1, 1} {}

Approach::Approach(const Sphere& sphere, const Patch& at) {
  const CentreDistance pair(WithCentre(sphere, at), at);
  const Distance distance(pair.nearest.feature, pair.x);
  d = pair.nearest.d - sphere.radius;
  // From the patch to the centre is into the sphere. A centre on the patch has no side.
  normal = distance.d > 0 ? Vec3(-distance.n) : Vec3(Vec3::UnitY());
  for (int i = 0; i < distance.nodes; ++i) c[pair.nearest.node[i]] = -distance.c[i];
}

PairMatrix approach_tangent(const Plane& plane, const Patch& at, double /*first*/, double second, Definiteness) {
  const Approach here(plane, at);
  const PairVector g = spread(here.c, here.normal);
  return second * g * g.transpose();
}

PairMatrix approach_tangent(const Sphere& sphere, const Patch& at, double first, double second, Definiteness fix) {
  const CentreDistance pair(WithCentre(sphere, at), at);
  const Distance distance(pair.nearest.feature, pair.x);
  return put(pair.nearest.node, distance.nodes, pair_tangent(distance, first, second, fix));
}

// The a at which d = 0, as the plane moves and turns:
//   (m + a dm).(r + a dr) = 0,  m the normal, r from the plane's point to x
double way_to(const Plane& plane, const Plane& by, const Patch& at, const Patch& move, double /*dh*/) {
  const Vec3 r = at.x[0] - plane.point, dr = move.x[0] - by.point;
  return first_root(plane.normal.dot(r), plane.normal.dot(dr) + by.normal.dot(r), by.normal.dot(dr));
}

// What cannot move as far as the gap is free.
double way_to(const Sphere& sphere, const Sphere& by, const Patch& at, const Patch& move, double dh) {
  constexpr double kept = 0.2;
  const WithCentre x(sphere, at), p(by, move);
  const double d = gap(sphere, at);
  double farthest = 0;
  for (int i = 1; i <= at.count; ++i) farthest = std::max(farthest, (p.x[i] - p.x[0]).norm());
  const double left = kept * std::min(d, dh);
  if (farthest < d - left) return none;
  const double limit = step_limit(kind_of(at), x.x, p.x, sphere.radius + left, 1);
  return limit < 1 ? limit : none;
}

//   d = n.(x - P), so shift = dP - n (x - P).dn,  dn = (I - n n^T) dm/|m|
Vec3 shift_of(const Plane& plane, const Plane& by, const Patch& at) {
  const Vec3 n = plane.normal.normalized(), dn = (by.normal - n.dot(by.normal) * n) / plane.normal.norm();
  return by.point - (at.x[0] - plane.point).dot(dn) * n;
}
Vec3 shift_of(const Sphere&, const Sphere& by, const Patch& /*at*/) {
  return by.centre;
}

}  // namespace sim
