#include "sim/contact/distance.h"

#include <Eigen/LU>
#include <cmath>

namespace sim {

namespace {

// Below this sine squared between two directions they count as parallel. [A threshold on lengths would not do: it has
// a unit.]
constexpr double parallel = 1e-14;

Nearest with(Feature feature, std::array<int, 4> node, const Vec3& w) {
  return {feature, node, w.norm()};
}

// Point p against the edge from a to b, all three numbers of nodes of the pair.
Nearest point_edge(const Vec3* x, int p, int a, int b) {
  const Vec3 edge = x[b] - x[a], arm = x[p] - x[a];
  const double length2 = edge.squaredNorm(), along = arm.dot(edge);
  if (!(along > 0)) return with(Feature::point_point, {p, a, -1, -1}, arm);
  if (!(along < length2)) return with(Feature::point_point, {p, b, -1, -1}, x[p] - x[b]);
  return with(Feature::point_edge, {p, a, b, -1}, arm - along / length2 * edge);
}

void keep_nearer(const Nearest& other, Nearest& best) {
  if (other.d < best.d) best = other;
}

// Minimum of |w_0 + a u + b v| over a and b; false where u and v are parallel.
bool inner_minimum(const Vec3& w0, const Vec3& u, const Vec3& v, double& a, double& b) {
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w0), vw = v.dot(w0);
  const double den = uu * vv - uv * uv;
  if (!(den > parallel * uu * vv)) return false;
  a = (uv * vw - vv * uw) / den;
  b = (uv * uw - uu * vw) / den;
  return true;
}

}  // namespace

Nearest nearest_point_edge(const Vec3* x) {
  return point_edge(x, 0, 1, 2);
}

Nearest nearest_point_triangle(const Vec3* x) {
  const Vec3 w0 = x[0] - x[1], u = x[1] - x[2], v = x[1] - x[3];
  double a, b;
  if (inner_minimum(w0, u, v, a, b) && a > 0 && b > 0 && a + b < 1)
    return with(Feature::point_triangle, {0, 1, 2, 3}, w0 + a * u + b * v);
  Nearest best = point_edge(x, 0, 1, 2);
  keep_nearer(point_edge(x, 0, 2, 3), best);
  keep_nearer(point_edge(x, 0, 3, 1), best);
  return best;
}

Nearest nearest_edge_edge(const Vec3* x) {
  const Vec3 w0 = x[0] - x[2], u = x[1] - x[0], v = x[2] - x[3];
  double s, t;
  if (inner_minimum(w0, u, v, s, t) && s > 0 && s < 1 && t > 0 && t < 1)
    return with(Feature::edge_edge, {0, 1, 2, 3}, w0 + s * u + t * v);
  Nearest best = point_edge(x, 0, 2, 3);
  keep_nearer(point_edge(x, 1, 2, 3), best);
  keep_nearer(point_edge(x, 2, 0, 1), best);
  keep_nearer(point_edge(x, 3, 0, 1), best);
  return best;
}

Distance::Distance(Feature feature, const Vec3* x)
    : nodes(node_count(feature)), parameters(nodes - 2), w_k{Vec3::Zero(), Vec3::Zero()} {
  static constexpr double start[4][4] = {{1, -1, 0, 0}, {1, -1, 0, 0}, {1, -1, 0, 0}, {1, 0, -1, 0}};
  static constexpr double rate[4][2][4] = {
      {}, {{0, 1, -1, 0}}, {{0, 1, -1, 0}, {0, 1, 0, -1}}, {{-1, 1, 0, 0}, {0, 0, 1, -1}}};
  const int kind = static_cast<int>(feature);
  // Differences of positions, so that a place far from the origin costs no digits; the c of each kind sum to 0.
  const int other = feature == Feature::edge_edge ? 2 : 1;
  Vec3 w = x[0] - x[other];
  for (int k = 0; k < parameters; ++k)
    for (int i = 0; i < nodes; ++i) {
      c_k[k][i] = rate[kind][k][i];
      if (i > 0) w_k[k] += c_k[k][i] * (x[i] - x[0]);
    }
  Eigen::Vector2d beta = Eigen::Vector2d::Zero();
  if (parameters == 1) {
    inverse_G(0, 0) = 1 / w_k[0].squaredNorm();
    beta[0] = -inverse_G(0, 0) * w_k[0].dot(w);
  } else if (parameters == 2) {
    Eigen::Matrix2d G;
    G << w_k[0].dot(w_k[0]), w_k[0].dot(w_k[1]), w_k[0].dot(w_k[1]), w_k[1].dot(w_k[1]);
    inverse_G = G.inverse();
    beta = -inverse_G * Eigen::Vector2d(w_k[0].dot(w), w_k[1].dot(w));
  }
  for (int i = 0; i < nodes; ++i) {
    c[i] = start[kind][i];
    for (int k = 0; k < parameters; ++k) c[i] += beta[k] * c_k[k][i];
  }
  for (int k = 0; k < parameters; ++k) w += beta[k] * w_k[k];
  d = w.norm();
  n = w / d;
}

PairVector Distance::gradient() const {
  PairVector g = PairVector::Zero();
  for (int i = 0; i < nodes; ++i) g.segment<3>(3 * i) = c[i] * n;
  return g;
}

PairMatrix Distance::hessian() const {
  PairMatrix H = PairMatrix::Zero();
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - n * n.transpose();
  for (int i = 0; i < nodes; ++i)
    for (int j = 0; j < nodes; ++j) H.block<3, 3>(3 * i, 3 * j) = c[i] * c[j] / d * across;
  Eigen::Matrix<double, 12, 2> B = Eigen::Matrix<double, 12, 2>::Zero();
  for (int k = 0; k < parameters; ++k)
    for (int i = 0; i < nodes; ++i) B.block<3, 1>(3 * i, k) = c_k[k][i] * d * n + c[i] * w_k[k];
  return H - B * inverse_G * B.transpose() / d;
}

}  // namespace sim
