#include "sim/contact/touch.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "sim/contact/mollifier.h"

namespace sim {

namespace {

void put_in_order(Touch& t) {
  auto& p = t.point;
  switch (t.feature) {
    case Feature::point_point:
      if (p[0] > p[1]) std::swap(p[0], p[1]);
      break;
    case Feature::point_edge:
      if (p[1] > p[2]) std::swap(p[1], p[2]);
      break;
    case Feature::point_triangle:
      std::sort(p.begin() + 1, p.end());
      break;
    case Feature::edge_edge:
      if (p[0] > p[1]) std::swap(p[0], p[1]);
      if (p[2] > p[3]) std::swap(p[2], p[3]);
      if (p[0] > p[2]) {
        std::swap(p[0], p[2]);
        std::swap(p[1], p[3]);
      }
      break;
  }
}

Touch touch_of(const Nearest& nearest, const int* points, int couple, double weight) {
  Touch t{nearest.feature, {-1, -1, -1, -1}, couple, weight};
  t.d = nearest.d;
  for (int i = 0; i < node_count(nearest.feature); ++i) t.point[i] = points[nearest.node[i]];
  put_in_order(t);
  return t;
}

// What a face takes off for its edges and adds for its points, with the point's weight.
void add_parts_of_face(const Skin& skin, const Candidate& candidate, const Couple& couple, const int* points,
                       const Vec3* x, double weight, std::vector<Touch>& touches) {
  const double reach = couple.dh + couple.xi;
  const int corners = skin.corners();
  for (int i = 0; i < corners; ++i) {
    const int v = points[1 + i], pair[2] = {points[0], v};
    const Vec3 w = x[0] - x[1 + i];
    if (skin.faces_around[v] > 0 && w.norm() < reach)
      touches.push_back(touch_of({Feature::point_point, {0, 1, -1, -1}, w.norm()}, pair, candidate.couple,
                                 (corners == 2 ? -1.0 : 1.0) / skin.faces_around[v] * weight));
    if (corners == 2 || !skin.edge_inside[skin.face_edges[candidate.second][i]]) continue;
    const int next = 1 + (i + 1) % 3, ends[3] = {points[0], v, points[next]};
    const Vec3 y[3] = {x[0], x[1 + i], x[next]};
    const Nearest edge = nearest_point_edge(y);
    if (edge.d < reach) touches.push_back(touch_of(edge, ends, candidate.couple, -0.5 * weight));
  }
}

}  // namespace

bool add_touches(const Skin& skin, const std::vector<Couple>& couples, const Candidate& candidate,
                 const Eigen::Matrix3Xd& positions, std::vector<Touch>& touches) {
  int points[4];
  Vec3 x[4];
  const int count = points_of(skin, candidate, points);
  for (int i = 0; i < count; ++i) x[i] = positions.col(points[i]);
  const Couple& couple = couples[candidate.couple];
  const Nearest at = nearest(candidate.kind, x);
  if (!(at.d > couple.xi)) return false;
  if (at.d >= couple.xi + couple.dh) return true;
  if (candidate.kind != PairKind::edge_edge) {
    const double weight = couple.kappa * skin.point_area[points[0]] / 2;
    touches.push_back(touch_of(at, points, candidate.couple, weight));
    add_parts_of_face(skin, candidate, couple, points, x, weight, touches);
    return true;
  }
  constexpr double half_pi = 1.57079632679489661923;
  const int e = candidate.first, f = candidate.second;
  const double lengths = skin.edge_length[e] * skin.edge_length[f];
  const double weight = couple.kappa * edge_share * half_pi * skin.edge_area[e] * skin.edge_area[f] / lengths;
  const double start =
      mollifier_start(skin.edge_length[e] * skin.edge_length[e], skin.edge_length[f] * skin.edge_length[f]);
  if (mollifier(x, start) == 1) {
    touches.push_back(touch_of(at, points, candidate.couple, weight));
  } else {
    touches.push_back(
        {at.feature, {points[0], points[1], points[2], points[3]}, candidate.couple, weight, start, at.node, at.d});
  }
  return true;
}

void gather(std::vector<Touch>& touches) {
  const auto key = [](const Touch& t) { return std::tuple(t.couple, t.feature, t.e > 0, t.point, t.weight); };
  std::sort(touches.begin(), touches.end(), [&](const Touch& a, const Touch& b) { return key(a) < key(b); });
  // Weights that cancel are shares of one number: what round-off leaves of them is dropped.
  constexpr double round_off = 1e-9;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < touches.size();) {
    Touch sum = touches[k];
    double largest = std::abs(sum.weight);
    std::size_t next = k + 1;
    for (; next < touches.size() && touches[next].same(sum); ++next) {
      sum.weight += touches[next].weight;
      largest = std::max(largest, std::abs(touches[next].weight));
    }
    if (std::abs(sum.weight) > round_off * largest) touches[kept++] = sum;
    k = next;
  }
  touches.resize(kept);
}

}  // namespace sim
