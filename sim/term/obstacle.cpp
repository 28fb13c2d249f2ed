#include "sim/term/obstacle.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <string_view>
#include <variant>

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

// The a at which d(x + a p) = 0, infinity where there is none ahead; d is the distance at x and n its gradient.
double way_to(const Plane&, const Vec3& /*x*/, const Vec3& p, double d, const Vec3& n) {
  return n.dot(p) < 0 ? d / -n.dot(p) : std::numeric_limits<double>::infinity();
}
// |x + a p - c|^2 = r^2
double way_to(const Sphere& sphere, const Vec3& x, const Vec3& p, double d, const Vec3& /*n*/) {
  const double A = p.squaredNorm(), B = (x - sphere.centre).dot(p), C = d * (d + 2 * sphere.radius);
  const double discriminant = B * B - A * C;
  return B < 0 && discriminant >= 0 ? C / (std::sqrt(discriminant) - B) : std::numeric_limits<double>::infinity();
}

}  // namespace

// Per contact: the normal force and direction when the step began, and the block of the last linearisation.
struct ObstacleTerm::Blocks : Store {
  std::vector<double> lambda;
  std::vector<Vec3> normal;
  std::vector<Eigen::Matrix3d> K;
};

ObstacleTerm::ObstacleTerm(const Obstacle& obstacle, std::vector<Contact> contacts, double dh, double eps, int D)
    : obstacle_(obstacle), contacts_(std::move(contacts)), dh_(dh), eps_(eps), D_(D) {}

TermInfo ObstacleTerm::info() const {
  std::ostringstream what;
  what << std::visit([](const auto& shape) { return name_of(shape); }, obstacle_.shape) << ", " << contacts_.size()
       << " nodes, barrier from " << dh_ << " m, friction " << obstacle_.friction;
  return {"obstacle", what.str()};
}

std::unique_ptr<Term::Store> ObstacleTerm::make_store(int threads) const {
  auto store = std::make_unique<Blocks>();
  store->threads = threads;
  store->lambda.assign(contacts_.size(), 0);
  store->normal.assign(contacts_.size(), Vec3::Zero());
  store->K.assign(contacts_.size(), Eigen::Matrix3d::Zero());
  return store;
}

Vec3 ObstacleTerm::at(const Eigen::VectorXd& x, int node) const {
  Vec3 point = Vec3::Zero();
  point.head(D_) = x.segment(static_cast<Eigen::Index>(node) * D_, D_);
  return point;
}

double ObstacleTerm::distance(const Vec3& x, Vec3& normal) const {
  return std::visit([&](const auto& shape) { return distance_to(shape, x, normal); }, obstacle_.shape);
}

Eigen::Matrix3d ObstacleTerm::curvature(const Vec3& normal, double d) const {
  return std::visit([&](const auto& shape) { return curvature_of(shape, normal, d); }, obstacle_.shape);
}

void ObstacleTerm::begin_step(const Motion& start, Store& store) const {
  auto& s = static_cast<Blocks&>(store);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const double d = distance(at(start.x, contacts_[k].node), s.normal[k]);
    s.lambda[k] = d > 0 && d < dh_ ? -contacts_[k].kappa * Barrier(d, dh_).first : 0;
  }
}

double ObstacleTerm::energy(const Motion& motion, Store& store) const {
  const auto& s = static_cast<const Blocks&>(store);
  double U = 0;
  Vec3 n;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const double d = distance(at(motion.x, contacts_[k].node), n);
    if (!(d > 0)) return std::numeric_limits<double>::infinity();
    if (d < dh_) U += contacts_[k].kappa * Barrier(d, dh_).b;
    if (motion.dv_dx == 0 || s.lambda[k] == 0 || obstacle_.friction == 0) continue;
    const Vec3 v = at(motion.v, contacts_[k].node), slip = slip_of(v, s.normal[k]);
    U += obstacle_.friction * s.lambda[k] * SmoothFriction(slip.norm(), eps_).f0 / motion.dv_dx;
  }
  return U;
}

void ObstacleTerm::add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const {
  const auto& s = static_cast<const Blocks&>(store);
  Vec3 n;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const int node = contacts_[k].node;
    Vec3 force = Vec3::Zero();
    const double d = distance(at(motion.x, node), n);
    if (d < dh_) force -= contacts_[k].kappa * Barrier(d, dh_).first * n;
    if (s.lambda[k] != 0 && obstacle_.friction != 0) {
      const Vec3 v = at(motion.v, node), slip = slip_of(v, s.normal[k]);
      force -= obstacle_.friction * s.lambda[k] * slip_gradient(slip, eps_);
    }
    f.segment(static_cast<Eigen::Index>(node) * D_, D_) += force.head(D_);
  }
}

void ObstacleTerm::linearise(const Motion& motion, Definiteness fix, Store& store, Eigen::VectorXd& f) const {
  auto& s = static_cast<Blocks&>(store);
  add_forces(motion, store, f);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    Vec3 n;
    s.K[k].setZero();
    const double d = distance(at(motion.x, contacts_[k].node), n);
    if (d < dh_) {
      const Barrier b(d, dh_);
      s.K[k] += contacts_[k].kappa * b.second * n * n.transpose();
      // Repulsion from a sphere weakens sideways: a negative part, kept only in the exact tangent.
      if (fix == Definiteness::none) s.K[k] += contacts_[k].kappa * b.first * curvature(n, d);
    }
    if (s.lambda[k] == 0 || obstacle_.friction == 0) continue;
    const Vec3 v = at(motion.v, contacts_[k].node), slip = slip_of(v, s.normal[k]);
    s.K[k] += obstacle_.friction * s.lambda[k] * motion.dv_dx * slip_tangent(slip, s.normal[k], eps_);
  }
}

void ObstacleTerm::add_product(const Store& store, double scale, const Eigen::VectorXd& p, Eigen::VectorXd& y) const {
  const auto& s = static_cast<const Blocks&>(store);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const Vec3 Kp = scale * s.K[k] * at(p, contacts_[k].node);
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
  double largest = 1;
  Vec3 n;
  for (const Contact& contact : contacts_) {
    const Vec3 x = at(motion.x, contact.node), p = at(dx, contact.node);
    const double d = distance(x, n);
    const double way = std::visit([&](const auto& shape) { return way_to(shape, x, p, d, n); }, obstacle_.shape);
    largest = std::min(largest, way);
  }
  return largest;
}

}  // namespace sim
