// The distance of two primitives of a surface and its derivatives, by one formula for every case:
//   d = min |w(beta)|,  w = sum_i c_i(beta) x_i,  c linear in beta
//   c: point-point (1, -1); point-edge (1, -(1-t), -t); point-triangle (1, -(1-a-b), -a, -b);
//      edge-edge (1-s, s, -(1-t), -t)
// With c_k = dc/dbeta_k, w_k = sum_i c_k,i x_i, G_kl = w_k . w_l, n = w/d, all at the minimum:
//   grad d: block i = c_i n
//   Hess d = (1/d) [ C^T (I - n n^T) C - B G^-1 B^T ],  C = (c_1 I ... c_m I),  B_k: block i = c_k,i w + c_i w_k
// In the plane the third number of every position is 0.
#pragma once

#include <array>

#include "sim/math/vec3.h"

namespace sim {

// What carries the closest points, once the parameters at an end of their range are left out.
enum class Feature { point_point, point_edge, point_triangle, edge_edge };

constexpr int node_count(Feature feature) {
  return feature == Feature::point_point ? 2 : feature == Feature::point_edge ? 3 : 4;
}

struct Nearest {
  Feature feature = Feature::point_point;
  std::array<int, 4> node = {-1, -1, -1, -1};  // places among the nodes of the pair, in the order of c above
  double d = 0;                                // m
};

// Nodes of the pair: the point, then the edge or the triangle; an edge, then the other.
Nearest nearest_point_edge(const Vec3* x);
Nearest nearest_point_triangle(const Vec3* x);
Nearest nearest_edge_edge(const Vec3* x);

using PairVector = Eigen::Matrix<double, 12, 1>;
using PairMatrix = Eigen::Matrix<double, 12, 12>;

// At the closest points of a feature, which must lie inside of it.
struct Distance {
  // x: positions of node_count(feature) nodes
  Distance(Feature feature, const Vec3* x);

  PairVector gradient() const;  // 3 numbers per node, 0 beyond the last
  PairMatrix hessian() const;

  int nodes, parameters;
  double c[4] = {}, c_k[2][4] = {};
  Vec3 n, w_k[2];
  double d;
  Eigen::Matrix2d inverse_G = Eigen::Matrix2d::Zero();
};

}  // namespace sim
