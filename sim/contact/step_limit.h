// How far two primitives may move along straight ways before they touch: additive continuous collision detection, which
// needs nothing but distances. [Li, Kaufman, Jiang 2021; the bound along a direction: Mirtich 1996]
// Along the direction n between the closest points all nodes i of the one primitive are at least d beyond all nodes j
// of the other, and as both are convex, d stays above
//   min over i and j of n.(x_i - x_j) + a n.(dx_i - dx_j),
// so a rises to where that is a tenth of what is left, until d is below a tenth of what it was at the start. By the
// length of dx_i - dx_j alone, which bounds the fall as well, what slides past at a small distance was stopped every
// time: edges that slid by 25 dh at 0.007 dh after 1.5 % of their way.
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

// The part of dx in [0, most] on all of which d > least; `most` where there is no limit below it. d(x) > least.
double step_limit(PairKind kind, const Vec3* x, const Vec3* dx, double least, double most);

}  // namespace sim
