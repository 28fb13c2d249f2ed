#include "sim/contact/freeing.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace sim {

namespace {

auto points_of_part(const Skin& skin, int part, const Eigen::Matrix3Xd& x) {
  const Span& points = skin.parts[part].points;
  return x.middleCols(points.first, points.size());
}

Vec3 normal_of(const Skin& skin, int face, const Eigen::Matrix3Xd& x) {
  const auto& f = skin.faces[face];
  const Vec3 edge = x.col(f[1]) - x.col(f[0]);
  return skin.D == 2 ? Vec3(edge.y(), -edge.x(), 0) : Vec3(edge.cross(x.col(f[2]) - x.col(f[0])));
}

// Where to try: along the axes, between the middles, and along normals of faces that reach into the other's box; a
// direction that is nearly another is left out.
std::vector<Vec3> directions(const Skin& skin, const Couple& couple, const Eigen::Matrix3Xd& x) {
  constexpr std::size_t most = 20;
  constexpr double alike = 0.999;
  std::vector<Vec3> all;
  const auto add = [&](const Vec3& v) {
    if (all.size() >= most || v.norm() == 0) return;
    const Vec3 n = v.normalized();
    for (const Vec3& other : all)
      if (n.dot(other) > alike) return;
    all.push_back(n);
  };
  for (int axis = 0; axis < skin.D; ++axis)
    for (const double sign : {1.0, -1.0}) add(sign * Vec3::Unit(axis));
  const Vec3 between =
      points_of_part(skin, couple.b, x).rowwise().mean() - points_of_part(skin, couple.a, x).rowwise().mean();
  for (const double sign : {1.0, -1.0}) add(sign * between);
  for (const bool turned : {false, true}) {
    const Eigen::Matrix3Xd other = points_of_part(skin, turned ? couple.a : couple.b, x);
    const Bounds box(other.rowwise().minCoeff(), other.rowwise().maxCoeff());
    const Span& faces = skin.parts[turned ? couple.b : couple.a].faces;
    for (int f = faces.first; f < faces.last; ++f) {
      if (!box.contains(x.col(skin.faces[f][0])) && !box.contains(x.col(skin.faces[f][1]))) continue;
      for (const double sign : {1.0, -1.0}) add(sign * normal_of(skin, f, x));
    }
  }
  return all;
}

}  // namespace

std::optional<Vec3> freeing_translation(const Surfaces& surfaces, const Couple& couple, int mover,
                                        const Eigen::Matrix3Xd& x) {
  if (couple.a == couple.b) return std::nullopt;
  const Skin& skin = surfaces.skin;
  const int other = mover == couple.a ? couple.b : couple.a;
  const auto moving = points_of_part(skin, mover, x), staying = points_of_part(skin, other, x);
  Eigen::Matrix3Xd moved = x;
  const auto is_free = [&](const Vec3& way) {
    const Span& points = skin.parts[mover].points;
    moved.middleCols(points.first, points.size()) = moving.colwise() + way;
    return meeting(surfaces, couple, moved, couple.dh).how == Meet::apart;
  };
  double shortest = std::numeric_limits<double>::infinity();
  std::optional<Vec3> best;
  for (const Vec3& n : directions(skin, couple, x)) {
    // On the other side of a plane across n they are surely apart. They may be so before, where a body is hollow.
    const double far =
        (n.transpose() * staying).maxCoeff() - (n.transpose() * moving).minCoeff() + 1.01 * (couple.dh + couple.xi);
    constexpr int looks = 12, halvings = 24;
    double held = 0, free = std::numeric_limits<double>::infinity();
    for (int k = 1; k <= looks; ++k) {
      const double t = far * k / looks;
      if (t >= shortest) break;
      if (k == looks || is_free(t * n)) {
        free = t;
        break;
      }
      held = t;
    }
    for (int k = 0; k < halvings && free < shortest && free - held > 1e-4 * free; ++k) {
      const double middle = (held + free) / 2;
      (is_free(middle * n) ? free : held) = middle;
    }
    if (free >= shortest) continue;
    shortest = free;
    best = free * n;
  }
  return best;
}

}  // namespace sim
