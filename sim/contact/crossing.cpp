#include "sim/contact/crossing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sim/contact/round_off.h"

namespace sim {

namespace {

// Six times the signed volume of a tetrahedron; twice the signed area of a triangle in the plane.
double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}
double area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a).z();
}

// Two heights over a plane, times a length or an area `over`, on either side of it.
bool are_apart(double p, double q, double over, double least) {
  return p * q < 0 && std::min(std::abs(p), std::abs(q)) > least * over;
}

bool crosses(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c, double least) {
  const double over = (b - a).cross(c - a).norm();
  if (!are_apart(volume(a, b, c, p), volume(a, b, c, q), over, least)) return false;
  const double u = volume(p, q, a, b), v = volume(p, q, b, c), w = volume(p, q, c, a);
  return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

bool crosses(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, double least) {
  return are_apart(area(p, q, a), area(p, q, b), (q - p).norm(), least) &&
         are_apart(area(a, b, p), area(a, b, q), (b - a).norm(), least);
}

}  // namespace

std::vector<Crossing> crossings(const Skin& skin, const std::vector<Couple>& couples, const BroadPhase& broad_phase,
                                const Eigen::Matrix3Xd& x) {
  Boxes boxes;
  for (Eigen::Index p = 0; p < x.cols(); ++p) boxes.points.emplace_back(x.col(p), x.col(p));
  std::vector<Crossing> all;
  const double least = round_off_gap(x);
  broad_phase.visit_edges_and_faces(couples, boxes, [&](int couple, int edge, int face) {
    const auto& ends = skin.D == 2 ? std::array<int, 2>{skin.faces[edge][0], skin.faces[edge][1]} : skin.edges[edge];
    const auto& f = skin.faces[face];
    for (const int end : ends)
      if (end == f[0] || end == f[1] || end == f[2]) return;
    const Vec3 p = x.col(ends[0]), q = x.col(ends[1]), a = x.col(f[0]), b = x.col(f[1]);
    const bool through = skin.D == 2 ? crosses(p, q, a, b, least) : crosses(p, q, a, b, x.col(f[2]), least);
    if (through) all.push_back({couple, (p + q) / 2});
  });
  return all;
}

}  // namespace sim
