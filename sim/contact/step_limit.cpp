#include "sim/contact/step_limit.h"

#include <algorithm>
#include <cmath>

namespace sim {

Nearest nearest(PairKind kind, const Vec3* x) {
  if (kind == PairKind::point_edge) return nearest_point_edge(x);
  return kind == PairKind::point_triangle ? nearest_point_triangle(x) : nearest_edge_edge(x);
}

double step_limit(PairKind kind, const Vec3* x, const Vec3* dx, double xi, double most) {
  constexpr double advance = 0.9, kept = 0.1;
  constexpr int most_iterations = 64;  // what was reached until then is safe
  const int nodes = node_count(kind), first = first_count(kind);
  double L2 = 0;
  for (int i = 0; i < first; ++i)
    for (int j = first; j < nodes; ++j) L2 = std::max(L2, (dx[i] - dx[j]).squaredNorm());
  if (L2 == 0) return most;
  const double L = std::sqrt(L2), gap_0 = nearest(kind, x).d - xi;
  double a = 0, gap = gap_0;
  Vec3 y[4];
  for (int k = 0; k < most_iterations; ++k) {
    const double next = a + advance * gap / L;
    if (next >= most) return most;
    for (int i = 0; i < nodes; ++i) y[i] = x[i] + next * dx[i];
    gap = nearest(kind, y).d - xi;
    // The first advance always counts, so that nothing is stuck where it starts.
    if (a > 0 && gap < kept * gap_0) return a;
    a = next;
  }
  return a;
}

}  // namespace sim
