#include "sim/contact/meeting.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/contact/crossing.h"
#include "sim/contact/distance.h"
#include "sim/contact/round_off.h"

namespace sim {

namespace {

constexpr double two_pi = 6.28318530717958647693;

// How often a part winds around a point: 1 inside a closed surface, 0 outside. [van Oosterom and Strackee 1983]
double winding(const Skin& skin, const Skin::Part& part, const Eigen::Matrix3Xd& x, const Vec3& point) {
  double angle = 0;  // of 4 pi, in the plane of 2 pi
  for (int f = part.faces.first; f < part.faces.last; ++f) {
    const auto& face = skin.faces[f];
    const Vec3 a = x.col(face[0]) - point, b = x.col(face[1]) - point;
    if (skin.D == 2) {
      angle += 2 * std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
      continue;
    }
    const Vec3 c = x.col(face[2]) - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return std::abs(angle) / (2 * two_pi);
}

bool is_closed(const Skin& skin, const Skin::Part& part) {
  if (skin.D == 2) {
    for (int p = part.points.first; p < part.points.last; ++p)
      if (skin.faces_around[p] == 0) return false;
    return true;
  }
  for (int e = part.edges.first; e < part.edges.last; ++e)
    if (!skin.edge_inside[e]) return false;
  return part.faces.size() > 0;
}

// In the middle of a face, a little below it: inside the body that it bounds.
Vec3 below(const Skin& skin, int face, const Eigen::Matrix3Xd& x) {
  constexpr double deep = 1e-7;  // of the face: less than any overlap that matters
  const auto& f = skin.faces[face];
  const Vec3 edge = x.col(f[1]) - x.col(f[0]);
  if (skin.D == 2) return (x.col(f[0]) + x.col(f[1])) / 2 - deep * Vec3(edge.y(), -edge.x(), 0);
  const Vec3 normal = edge.cross(x.col(f[2]) - x.col(f[0]));
  const double area = normal.norm();
  return (x.col(f[0]) + x.col(f[1]) + x.col(f[2])) / 3 - (area > 0 ? deep / std::sqrt(area) : 0) * normal;
}

// Middles of those faces of a solid part that lie inside the other part: of its faces where they touch, and one more.
// Surfaces that do not cross are in each other as a whole, but for places where they touch. A surface that bounds no
// body may hold one as a room does: that one is in it only where it is not all in it.
std::vector<Vec3> faces_inside(const Surfaces& surfaces, int of, int in, const std::vector<bool>& touching,
                               const Eigen::Matrix3Xd& x) {
  constexpr double in_it = 0.75;
  const Skin& skin = surfaces.skin;
  const Skin::Part &part = skin.parts[of], &other = skin.parts[in];
  if (!surfaces.is_solid[of] || !is_closed(skin, other)) return {};
  std::vector<Vec3> inside;
  std::size_t looks = 0;
  for (int f = part.faces.first; f < part.faces.last; ++f) {
    const auto& face = skin.faces[f];
    const bool is_near = touching[face[0]] || touching[face[1]] || (skin.D == 3 && touching[face[2]]);
    if (f > part.faces.first && !is_near) continue;
    ++looks;
    const Vec3 place = below(skin, f, x);
    if (winding(skin, other, x, place) > in_it) inside.push_back(place);
  }
  if (!surfaces.is_solid[in] && inside.size() == looks) inside.clear();
  return inside;
}

Vec3 closest_place(const Candidate& candidate, const Vec3* x, const Nearest& at) {
  Vec3 near[4];
  for (int i = 0; i < node_count(at.feature); ++i) near[i] = x[at.node[i]];
  const Distance distance(at.feature, near);
  Vec3 place = Vec3::Zero();
  for (int i = 0; i < distance.nodes; ++i)
    if (at.node[i] < first_count(candidate.kind)) place += std::abs(distance.c[i]) * near[i];
  return place;
}

// Each place once.
void leave_out_repeated(std::vector<Vec3>& places, double apart) {
  std::vector<Vec3> kept;
  for (const Vec3& place : places) {
    bool is_new = true;
    for (const Vec3& other : kept) is_new = is_new && (place - other).norm() > apart;
    if (is_new) kept.push_back(place);
  }
  places = kept;
}

// Places where the two are no further apart than `least`; the points of those primitives.
std::vector<Vec3> touching_places(const Surfaces& surfaces, const Couple& couple, const Eigen::Matrix3Xd& x,
                                  double least, std::vector<bool>& touching) {
  const Skin& skin = surfaces.skin;
  Boxes boxes;
  for (Eigen::Index p = 0; p < x.cols(); ++p) boxes.points.emplace_back(x.col(p), x.col(p));
  std::vector<Candidate> candidates;
  surfaces.broad_phase.find({{couple.a, couple.b, least, 0}}, std::numeric_limits<std::size_t>::max(), boxes,
                            candidates);
  std::vector<Vec3> places;
  for (const Candidate& candidate : candidates) {
    int points[4];
    Vec3 y[4];
    const int count = points_of(skin, candidate, points);
    for (int i = 0; i < count; ++i) y[i] = x.col(points[i]);
    const Nearest at = nearest(candidate.kind, y);
    if (at.d > least) continue;
    places.push_back(closest_place(candidate, y, at));
    for (int i = 0; i < count; ++i) touching[points[i]] = true;
  }
  return places;
}

}  // namespace

Meeting meeting(const Surfaces& surfaces, const Couple& couple, const Eigen::Matrix3Xd& x, double more) {
  Meeting it;
  for (const Crossing& crossing : crossings(surfaces.skin, {couple}, surfaces.broad_phase, x))
    it.places.push_back(crossing.at);
  if (!it.places.empty()) it.how = Meet::crosses;
  const double hidden = round_off_gap(x);
  std::vector<bool> touching(surfaces.skin.node.size(), false);
  if (it.how == Meet::apart) {
    it.places = touching_places(surfaces, couple, x, couple.xi + std::max(more, hidden), touching);
    if (!it.places.empty()) it.how = Meet::touches;
  }
  if (couple.a != couple.b && it.how != Meet::crosses) {
    std::vector<Vec3> inside = faces_inside(surfaces, couple.a, couple.b, touching, x);
    for (const Vec3& place : faces_inside(surfaces, couple.b, couple.a, touching, x)) inside.push_back(place);
    if (!inside.empty()) it = {Meet::crosses, std::move(inside)};
  }
  leave_out_repeated(it.places, 1e3 * hidden);
  return it;
}

Eigen::Matrix3Xd points_at(const Skin& skin, const Eigen::VectorXd& x) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(skin.node.size()));
  for (std::size_t p = 0; p < skin.node.size(); ++p)
    points.col(static_cast<Eigen::Index>(p)).head(skin.D) =
        x.segment(static_cast<Eigen::Index>(skin.node[p]) * skin.D, skin.D);
  return points;
}

}  // namespace sim
