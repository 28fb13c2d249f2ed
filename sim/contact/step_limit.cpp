#include "sim/contact/step_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {

Nearest nearest(PairKind kind, const Vec3* x) {
  if (kind == PairKind::point_edge) return nearest_point_edge(x);
  return kind == PairKind::point_triangle ? nearest_point_triangle(x) : nearest_edge_edge(x);
}

namespace {

// From the closest point of the second primitive to that of the first.
Vec3 direction_between(PairKind kind, const Vec3* x, const Nearest& at) {
  Vec3 near[4];
  for (int i = 0; i < node_count(at.feature); ++i) near[i] = x[at.node[i]];
  const Vec3 n = Distance(at.feature, near).n;
  return n.dot(x[0] - x[first_count(kind)]) < 0 ? Vec3(-n) : n;
}

// How far a may rise until n.(x_i - x_j) is `left` for some nodes i of the first primitive and j of the second: while
// all are more, nothing passes. Where one is less already, the gap d is so small that round-off has turned n, and no
// node may come nearer to another than `left` by its own motion, whatever the direction.
double advance_to(PairKind kind, const Vec3* x, const Vec3* dx, const Vec3& n, double d, double left) {
  const int nodes = node_count(kind), first = first_count(kind);
  double a = std::numeric_limits<double>::infinity(), apart = a, fastest = 0;
  for (int i = 0; i < first; ++i)
    for (int j = first; j < nodes; ++j) {
      const Vec3 closing = dx[j] - dx[i];
      const double fall = n.dot(closing), distance = n.dot(x[i] - x[j]);
      apart = std::min(apart, distance);
      fastest = std::max(fastest, closing.norm());
      if (fall > 0) a = std::min(a, (distance - left) / fall);
    }
  return apart > left ? a : (d - left) / fastest;
}

}  // namespace

double step_limit(PairKind kind, const Vec3* x, const Vec3* dx, double least, double most) {
  constexpr double kept = 0.1;
  constexpr int most_iterations = 64;  // what was reached until then is safe
  const int nodes = node_count(kind);
  Nearest at = nearest(kind, x);
  const double gap_0 = at.d - least;
  Vec3 y[4];
  std::copy(x, x + nodes, y);
  double a = 0;
  for (int k = 0; k < most_iterations; ++k) {
    const double next =
        a + advance_to(kind, y, dx, direction_between(kind, y, at), at.d, least + kept * (at.d - least));
    if (!(next < most)) return most;
    for (int i = 0; i < nodes; ++i) y[i] = x[i] + next * dx[i];
    at = nearest(kind, y);
    // The first advance always counts, so that nothing is stuck where it starts.
    if (a > 0 && at.d - least < kept * gap_0) return a;
    a = next;
  }
  return a;
}

}  // namespace sim
