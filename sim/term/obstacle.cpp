#include "sim/term/obstacle.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <string_view>
#include <variant>

#include "sim/body/pose.h"
#include "sim/contact/barrier.h"
#include "sim/contact/smooth_friction.h"

namespace sim {

namespace {

// One function for each shape and operation, so that a shape that lacks one does not compile.
std::string_view name_of(const Plane&) {
  return "plane";
}
std::string_view name_of(const Sphere&) {
  return "sphere";
}

double distance_to(const Plane& plane, const Vec3& x, Vec3& normal) {
  normal = plane.normal.normalized();
  return normal.dot(x - plane.point);
}
double distance_to(const Sphere& sphere, const Vec3& x, Vec3& normal) {
  const Vec3 arm = x - sphere.centre;
  normal = arm.norm() > 0 ? Vec3(arm.normalized()) : Vec3(Vec3::UnitY());
  return arm.norm() - sphere.radius;
}

// d2 d/dx2 at the distance d: zero for a plane, (I - n n^T)/|x - c| for a sphere.
Eigen::Matrix3d curvature_of(const Plane&, const Vec3& /*normal*/, double /*d*/) {
  return Eigen::Matrix3d::Zero();
}
Eigen::Matrix3d curvature_of(const Sphere& sphere, const Vec3& normal, double d) {
  return (Eigen::Matrix3d::Identity() - normal * normal.transpose()) / (d + sphere.radius);
}

// The least a > 0 at which c + b a + q a^2 = 0, infinity where there is none; c > 0.
double first_root(double c, double b, double q) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const double discriminant = b * b - 4 * q * c;
  if (discriminant < 0) return none;
  const double root = std::sqrt(discriminant);
  if (b < 0) return 2 * c / (root - b);
  return q < 0 ? (b + root) / (-2 * q) : none;
}

// The a at which d(x + a p) = 0 while the shape moves by a times `by`; d is the distance at x.
//   (m + a dm).(r + a dr) = 0,  m the normal, r from the plane's point to x
double way_to(const Plane& plane, const Plane& by, const Vec3& x, const Vec3& p, double /*d*/) {
  const Vec3 r = x - plane.point, dr = p - by.point;
  return first_root(plane.normal.dot(r), plane.normal.dot(dr) + by.normal.dot(r), by.normal.dot(dr));
}
// |r + a dr|^2 = R^2, r from the centre to x
double way_to(const Sphere& sphere, const Sphere& by, const Vec3& x, const Vec3& p, double d) {
  const Vec3 dr = p - by.centre;
  return first_root(d * (d + 2 * sphere.radius), 2 * (x - sphere.centre).dot(dr), dr.squaredNorm());
}

// How nodes whose shape moves by `by` shift the surface at x along its normal: d d = n.(dx - shift).
//   d = n.(x - P), so shift = dP - n (x - P).dn,  dn = (I - n n^T) dm
Vec3 shift_of(const Plane& plane, const Plane& by, const Vec3& x, const Vec3& n) {
  const Vec3 dn = (by.normal - n.dot(by.normal) * n) / plane.normal.norm();
  return by.point - (x - plane.point).dot(dn) * n;
}
Vec3 shift_of(const Sphere&, const Sphere& by, const Vec3& /*x*/, const Vec3& /*n*/) {
  return by.centre;
}

// What moves no node of its own stands still.
Plane still(const Plane&) {
  return {Vec3::Zero(), Vec3::Zero()};
}
Sphere still(const Sphere& sphere) {
  return {Vec3::Zero(), sphere.radius};
}

}  // namespace

// Per contact: the normal force, direction and place when the step began; of the last linearisation its block, and
// where it was made.
struct ObstacleTerm::Blocks : Store {
  std::vector<double> lambda;
  std::vector<Vec3> normal, begin;
  std::vector<Eigen::Matrix3d> K;
  std::vector<Vec3> place;
  Shape shape;
};

ObstacleTerm::ObstacleTerm(const Obstacle& obstacle, const ObstacleNodes& nodes, std::vector<Contact> contacts,
                           double dh, double eps, int D)
    : obstacle_(obstacle), nodes_(nodes), contacts_(std::move(contacts)), dh_(dh), eps_(eps), D_(D) {}

TermInfo ObstacleTerm::info() const {
  std::ostringstream what;
  const Shape rest = shape(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(nodes_.first + nodes_.count) * D_));
  what << std::visit([](const auto& it) { return name_of(it); }, rest) << ", " << contacts_.size()
       << " nodes, barrier from " << dh_ << " m, friction " << obstacle_.friction;
  if (!obstacle_.motion.empty()) what << ", moves";
  return {"obstacle", what.str()};
}

std::unique_ptr<Term::Store> ObstacleTerm::make_store(int threads) const {
  auto store = std::make_unique<Blocks>();
  store->threads = threads;
  store->lambda.assign(contacts_.size(), 0);
  store->normal.assign(contacts_.size(), Vec3::Zero());
  store->begin = store->place = store->normal;
  store->K.assign(contacts_.size(), Eigen::Matrix3d::Zero());
  return store;
}

Vec3 ObstacleTerm::at(const Eigen::VectorXd& x, int node) const {
  Vec3 point = Vec3::Zero();
  point.head(D_) = x.segment(static_cast<Eigen::Index>(node) * D_, D_);
  return point;
}

ObstacleTerm::Shape ObstacleTerm::shape(const Eigen::VectorXd& x) const {
  if (const auto* plane = std::get_if<Plane>(&obstacle_.shape)) return shape_at(*plane, nodes_, x, D_);
  return shape_at(std::get<Sphere>(obstacle_.shape), nodes_, x, D_);
}

double distance(const ObstacleTerm::Shape& shape, const Vec3& x, Vec3& normal) {
  return std::visit([&](const auto& it) { return distance_to(it, x, normal); }, shape);
}

ObstacleTerm::Nearest ObstacleTerm::nearest(const Eigen::VectorXd& x, double t) const {
  Nearest least{-1, 0, std::numeric_limits<double>::infinity()};
  if (is_gone(t)) return least;
  const Shape here = shape(x);
  Vec3 n;
  for (const Contact& contact : contacts_) {
    const double gap = distance(here, at(x, contact.node), n);
    if (gap / dh_ < least.share) least = {contact.node, gap, gap / dh_};
  }
  return least;
}

void ObstacleTerm::begin_step(const Motion& start, Store& store) const {
  auto& s = static_cast<Blocks&>(store);
  const Shape here = shape(start.x);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    s.begin[k] = at(start.x, contacts_[k].node);
    const double d = distance(here, s.begin[k], s.normal[k]);
    s.lambda[k] = d > 0 && d < dh_ ? -contacts_[k].kappa * Barrier(d, dh_).first : 0;
  }
}

// Of a node along the obstacle, which may move itself.
Vec3 ObstacleTerm::slip(const Motion& motion, const Blocks& s, std::size_t k) const {
  Vec3 v = at(motion.v, contacts_[k].node);
  if (!obstacle_.motion.empty()) v -= Pose(obstacle_.motion, motion.t).velocity(s.begin[k]);
  return slip_of(v, s.normal[k]);
}

double ObstacleTerm::energy(const Motion& motion, Store& store) const {
  if (is_gone(motion.t)) return 0;
  const auto& s = static_cast<const Blocks&>(store);
  const Shape here = shape(motion.x);
  double U = 0;
  Vec3 n;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const double d = distance(here, at(motion.x, contacts_[k].node), n);
    if (!(d > 0)) return std::numeric_limits<double>::infinity();
    if (d < dh_) U += contacts_[k].kappa * Barrier(d, dh_).b;
    if (motion.dv_dx == 0 || s.lambda[k] == 0 || obstacle_.friction == 0) continue;
    U += obstacle_.friction * s.lambda[k] * SmoothFriction(slip(motion, s, k).norm(), eps_).f0 / motion.dv_dx;
  }
  return U;
}

void ObstacleTerm::add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const {
  if (is_gone(motion.t)) return;
  const auto& s = static_cast<const Blocks&>(store);
  const Shape here = shape(motion.x);
  Vec3 n;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const int node = contacts_[k].node;
    Vec3 force = Vec3::Zero();
    const double d = distance(here, at(motion.x, node), n);
    if (d < dh_) force -= contacts_[k].kappa * Barrier(d, dh_).first * n;
    if (s.lambda[k] != 0 && obstacle_.friction != 0)
      force -= obstacle_.friction * s.lambda[k] * slip_gradient(slip(motion, s, k), eps_);
    f.segment(static_cast<Eigen::Index>(node) * D_, D_) += force.head(D_);
  }
}

void ObstacleTerm::linearise(const Motion& motion, Definiteness fix, Store& store, Eigen::VectorXd& f) const {
  auto& s = static_cast<Blocks&>(store);
  add_forces(motion, store, f);
  s.shape = shape(motion.x);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    Vec3 n;
    s.K[k].setZero();
    if (is_gone(motion.t)) continue;
    s.place[k] = at(motion.x, contacts_[k].node);
    const double d = distance(s.shape, s.place[k], n);
    if (d < dh_) {
      const Barrier b(d, dh_);
      s.K[k] += contacts_[k].kappa * b.second * n * n.transpose();
      // Repulsion from a sphere weakens sideways: a negative part, kept only in the exact tangent.
      if (fix == Definiteness::none)
        s.K[k] +=
            contacts_[k].kappa * b.first * std::visit([&](const auto& it) { return curvature_of(it, n, d); }, s.shape);
    }
    if (s.lambda[k] == 0 || obstacle_.friction == 0) continue;
    s.K[k] += obstacle_.friction * s.lambda[k] * motion.dv_dx * slip_tangent(slip(motion, s, k), s.normal[k], eps_);
  }
}

void ObstacleTerm::add_product(const Store& store, double scale, const Eigen::VectorXd& p, Eigen::VectorXd& y) const {
  const auto& s = static_cast<const Blocks&>(store);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    Vec3 moved = at(p, contacts_[k].node);
    if (nodes_.count > 0)
      moved -= std::visit(
          [&](const auto& it) {
            Vec3 n;
            distance_to(it, s.place[k], n);
            return shift_of(it, shape_at(it, nodes_, p, D_), s.place[k], n);
          },
          s.shape);
    const Vec3 Kp = scale * s.K[k] * moved;
    y.segment(static_cast<Eigen::Index>(contacts_[k].node) * D_, D_) += Kp.head(D_);
  }
}

void ObstacleTerm::add_matrix(const Store& store, double scale, BlockMatrix& A) const {
  const auto& s = static_cast<const Blocks&>(store);
  for (std::size_t k = 0; k < contacts_.size(); ++k)
    for (int i = 0; i < D_; ++i)
      for (int j = 0; j < D_; ++j) A.block(slot_[k])[i * D_ + j] += scale * s.K[k](i, j);
}

void ObstacleTerm::add_diagonal(const Store& store, double scale, Eigen::VectorXd& d) const {
  const auto& s = static_cast<const Blocks&>(store);
  for (std::size_t k = 0; k < contacts_.size(); ++k)
    d.segment(static_cast<Eigen::Index>(contacts_[k].node) * D_, D_) += scale * s.K[k].diagonal().head(D_);
}

void ObstacleTerm::bind(const BlockPattern& pattern) {
  for (const Contact& contact : contacts_) slot_.push_back(pattern.slot(contact.node, contact.node));
}

double ObstacleTerm::largest_step(const Motion& motion, const Eigen::VectorXd& dx, Store&) const {
  if (is_gone(motion.t)) return 1;
  double largest = 1;
  std::visit(
      [&](const auto& here) {
        const auto by = nodes_.count > 0 ? shape_at(here, nodes_, dx, D_) : still(here);
        Vec3 n;
        for (const Contact& contact : contacts_) {
          const Vec3 x = at(motion.x, contact.node);
          largest = std::min(largest, way_to(here, by, x, at(dx, contact.node), distance_to(here, x, n)));
        }
      },
      shape(motion.x));
  return largest;
}

}  // namespace sim
