#include "sim/solve/turning.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace sim {

namespace {

Vec3 part(const Eigen::VectorXd& all, int node, int D) {
  Vec3 v = Vec3::Zero();
  v.head(D) = all.segment(static_cast<Eigen::Index>(node) * D, D);
  return v;
}

// Means over a body, by mass, and its turn.
struct Turn {
  Vec3 c = Vec3::Zero(), d = Vec3::Zero(), w = Vec3::Zero();
};

Turn turn_in(const Mass& mass, int D, const Eigen::VectorXd& x, const Eigen::VectorXd& dx) {
  Turn it;
  const Eigen::VectorXd& m = mass.nodal();
  const int first = mass.first_node(), count = static_cast<int>(m.size());
  for (int i = 0; i < count; ++i) {
    it.c += m[i] * part(x, first + i, D);
    it.d += m[i] * part(dx, first + i, D);
  }
  it.c /= mass.total();
  it.d /= mass.total();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Vec3 momentum = Vec3::Zero();
  for (int i = 0; i < count; ++i) {
    const Vec3 r = part(x, first + i, D) - it.c;
    inertia += m[i] * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
    momentum += m[i] * r.cross(part(dx, first + i, D) - it.d);
  }
  it.w = inertia.inverse() * momentum;
  if (!it.w.allFinite()) it.w.setZero();
  return it;
}

}  // namespace

bool turn_along(const Model& model, const Eigen::VectorXd& free, double least, const Eigen::VectorXd& x,
                const Eigen::VectorXd& dx, Eigen::VectorXd& turned) {
  const int D = model.D;
  bool turns = false;
  turned = dx;
  for (std::size_t b = 0; b < model.ranges.size(); ++b) {
    const BodyRange& range = model.ranges[b];
    const Eigen::Index first = static_cast<Eigen::Index>(range.first_node) * D;
    if ((free.segment(first, static_cast<Eigen::Index>(range.node_count) * D).array() == 0).any()) continue;
    const Turn turn = turn_in(model.masses[b], D, x, dx);
    const double w = turn.w.norm();
    if (!(w > least)) continue;
    turns = true;
    const Eigen::Matrix3d R = Eigen::AngleAxisd(std::atan(w), turn.w / w).toRotationMatrix();
    for (int i = range.first_node; i < range.first_node + range.node_count; ++i) {
      const Vec3 r = part(x, i, D) - turn.c, u = part(dx, i, D) - turn.d - turn.w.cross(r);
      turned.segment(static_cast<Eigen::Index>(i) * D, D) = (turn.d + R * (r + u) - r).head(D);
    }
  }
  return turns;
}

}  // namespace sim
