// How far two primitives may move along straight ways before they touch: additive continuous collision detection, which
// needs nothing but distances. [Li, Kaufman, Jiang 2021; the bound L: Ando 2024]
//   L = max |dx_i - dx_j| over the nodes i of the one and j of the other: the distance falls by at most L da
//   a' = a + 0.9 (d(x + a dx) - xi)/L, until d at a' is below a tenth of what it was at the start
#pragma once

#include "sim/contact/distance.h"

namespace sim {

enum class PairKind { point_edge, point_triangle, edge_edge };

constexpr int node_count(PairKind kind) {
  return kind == PairKind::point_edge ? 3 : 4;
}
// Nodes of the first primitive; the second has the others.
constexpr int first_count(PairKind kind) {
  return kind == PairKind::edge_edge ? 2 : 1;
}
Nearest nearest(PairKind kind, const Vec3* x);

// The part of dx in [0, most] on all of which d > xi; `most` where there is no limit below it. d(x) > xi.
double step_limit(PairKind kind, const Vec3* x, const Vec3* dx, double xi, double most);

}  // namespace sim
