#include "sim/term/obstacle.h"

#include <limits>
#include <span>
#include <sstream>
#include <string_view>
#include <variant>

#include "sim/body/pose.h"
#include "sim/contact/barrier.h"
#include "sim/contact/smooth_friction.h"
#include "sim/contact/spread.h"

namespace sim {

namespace {

// One function for each shape and operation, so that a shape that lacks one does not compile.
std::string_view name_of(const Plane&) {
  return "plane";
}
std::string_view name_of(const Sphere&) {
  return "sphere";
}

// What moves no node of its own stands still.
Plane still(const Plane&) {
  return {Vec3::Zero(), Vec3::Zero()};
}
Sphere still(const Sphere& sphere) {
  return {Vec3::Zero(), sphere.radius};
}

}  // namespace

// Friction of one patch: what it keeps from where it was frozen. strength: mu lambda [N]; place: on the obstacle.
struct ObstacleTerm::Grip {
  std::size_t contact;
  double strength;
  Approach at;
  Vec3 place;
};

// The grips of the step; of the last linearisation the blocks, of the obstacle's place and the patch's nodes, and where
// they were made.
struct ObstacleTerm::Touched : Store {
  struct Block {
    std::size_t contact;
    Patch at;
    PairMatrix K;
  };
  std::vector<Grip> grips;
  std::vector<Block> blocks;
  Shape shape;
};

ObstacleTerm::ObstacleTerm(const Obstacle& obstacle, const ObstacleNodes& nodes, std::vector<Contact> contacts,
                           double dh, double eps, int D)
    : obstacle_(obstacle), nodes_(nodes), contacts_(std::move(contacts)), dh_(dh), eps_(eps), D_(D) {}

TermInfo ObstacleTerm::info() const {
  std::ostringstream what;
  const Shape rest = shape(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(nodes_.first + nodes_.count) * D_));
  what << std::visit([](const auto& it) { return name_of(it); }, rest) << ", " << contacts_.size()
       << (contacts_.empty() || contacts_[0].count == 1 ? " nodes" : " faces") << ", barrier from " << dh_
       << " m, friction " << obstacle_.friction;
  if (!obstacle_.motion.empty()) what << ", moves";
  return {"obstacle", what.str()};
}

std::unique_ptr<Term::Store> ObstacleTerm::make_store(int threads) const {
  auto store = std::make_unique<Touched>();
  store->threads = threads;
  store->grips.reserve(obstacle_.friction == 0 ? 0 : contacts_.size());
  store->blocks.reserve(2 * contacts_.size());
  return store;
}

Patch ObstacleTerm::patch(const Eigen::VectorXd& x, const Contact& contact) const {
  Patch at{contact.count, {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}};
  for (int i = 0; i < contact.count; ++i)
    at.x[i].head(D_) = x.segment(static_cast<Eigen::Index>(contact.node[i]) * D_, D_);
  return at;
}

ObstacleTerm::Shape ObstacleTerm::shape(const Eigen::VectorXd& x) const {
  if (const auto* plane = std::get_if<Plane>(&obstacle_.shape)) return shape_at(*plane, nodes_, x, D_);
  return shape_at(std::get<Sphere>(obstacle_.shape), nodes_, x, D_);
}

double gap(const ObstacleTerm::Shape& shape, const Patch& at) {
  return std::visit([&](const auto& it) { return gap(it, at); }, shape);
}

ObstacleTerm::Nearest ObstacleTerm::nearest(const Eigen::VectorXd& x, double t) const {
  Nearest least{-1, 0, std::numeric_limits<double>::infinity()};
  if (is_gone(t)) return least;
  const Shape here = shape(x);
  for (const Contact& contact : contacts_) {
    const double d = gap(here, patch(x, contact));
    if (d / dh_ < least.share) least = {contact.node[0], d, d / dh_};
  }
  return least;
}

void ObstacleTerm::begin_step(const Motion& start, Store& store) const {
  auto& s = static_cast<Touched&>(store);
  s.grips.clear();
  if (obstacle_.friction == 0) return;
  std::visit(
      [&](const auto& here) {
        for (std::size_t k = 0; k < contacts_.size(); ++k) {
          const Patch at = patch(start.x, contacts_[k]);
          if (const double d = gap(here, at); !(d > 0) || d >= dh_) continue;
          const Approach near(here, at);
          Vec3 place = Vec3::Zero();
          for (int i = 0; i < at.count; ++i) place += near.c[1 + i] * at.x[i];
          const double lambda = -contacts_[k].kappa * Barrier(near.d, dh_).first;
          s.grips.push_back({k, obstacle_.friction * lambda, near, place});
        }
      },
      shape(start.x));
}

// Of a patch along the obstacle, which may move itself.
Vec3 ObstacleTerm::slip(const Motion& motion, const Grip& grip) const {
  const Contact& contact = contacts_[grip.contact];
  const Patch v = patch(motion.v, contact);
  Vec3 w = Vec3::Zero();
  for (int i = 0; i < contact.count; ++i) w += grip.at.c[1 + i] * v.x[i];
  if (!obstacle_.motion.empty()) w -= Pose(obstacle_.motion, motion.t).velocity(grip.place);
  return slip_of(w, grip.at.normal);
}

double ObstacleTerm::energy(const Motion& motion, Store& store) const {
  if (is_gone(motion.t)) return 0;
  const auto& s = static_cast<const Touched&>(store);
  const Shape here = shape(motion.x);
  double U = 0;
  for (const Contact& contact : contacts_) {
    const double d = gap(here, patch(motion.x, contact));
    if (!(d > 0)) return std::numeric_limits<double>::infinity();
    if (d < dh_) U += contact.kappa * Barrier(d, dh_).b;
  }
  if (motion.dv_dx != 0)
    for (const Grip& grip : s.grips)
      U += grip.strength * SmoothFriction(slip(motion, grip).norm(), eps_).f0 / motion.dv_dx;
  return U;
}

// Of three numbers for the obstacle's place and for each node, those of the nodes.
void ObstacleTerm::scatter(const Contact& contact, const PairVector& force, Eigen::VectorXd& f) const {
  for (int i = 0; i < contact.count; ++i)
    f.segment(static_cast<Eigen::Index>(contact.node[i]) * D_, D_) += force.segment(3 * (1 + i), D_);
}

void ObstacleTerm::add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const {
  if (is_gone(motion.t)) return;
  const auto& s = static_cast<const Touched&>(store);
  std::visit(
      [&](const auto& here) {
        for (const Contact& contact : contacts_) {
          const Patch at = patch(motion.x, contact);
          if (gap(here, at) >= dh_) continue;
          const Approach near(here, at);
          scatter(contact, spread(near.c, Vec3(-contact.kappa * Barrier(near.d, dh_).first * near.normal)), f);
        }
      },
      shape(motion.x));
  for (const Grip& grip : s.grips)
    scatter(contacts_[grip.contact], spread(grip.at.c, Vec3(-grip.strength * slip_gradient(slip(motion, grip), eps_))),
            f);
}

void ObstacleTerm::linearise(const Motion& motion, Definiteness fix, Store& store, Eigen::VectorXd& f) const {
  auto& s = static_cast<Touched&>(store);
  add_forces(motion, store, f);
  s.shape = shape(motion.x);
  s.blocks.clear();
  if (is_gone(motion.t)) return;
  std::visit(
      [&](const auto& here) {
        for (std::size_t k = 0; k < contacts_.size(); ++k) {
          const Patch at = patch(motion.x, contacts_[k]);
          const double d = gap(here, at), kappa = contacts_[k].kappa;
          if (d >= dh_) continue;
          const Barrier b(d, dh_);
          s.blocks.push_back({k, at, approach_tangent(here, at, kappa * b.first, kappa * b.second, fix)});
        }
      },
      s.shape);
  for (const Grip& grip : s.grips) {
    const Eigen::Matrix3d K = grip.strength * motion.dv_dx * slip_tangent(slip(motion, grip), grip.at.normal, eps_);
    s.blocks.push_back({grip.contact, patch(motion.x, contacts_[grip.contact]), spread(grip.at.c, K)});
  }
}

void ObstacleTerm::add_product(const Store& store, double scale, const Eigen::VectorXd& p, Eigen::VectorXd& y) const {
  const auto& s = static_cast<const Touched&>(store);
  for (const Touched::Block& block : s.blocks) {
    const Patch moved = patch(p, contacts_[block.contact]);
    PairVector q = PairVector::Zero();
    for (int i = 0; i < moved.count; ++i) q.segment<3>(3 * (1 + i)) = moved.x[i];
    if (nodes_.count > 0)
      q.head<3>() =
          std::visit([&](const auto& it) { return shift_of(it, shape_at(it, nodes_, p, D_), block.at); }, s.shape);
    const int n = 3 * (1 + moved.count);
    PairVector Kq = PairVector::Zero();
    Kq.head(n) = scale * (block.K.topLeftCorner(n, n) * q.head(n));
    scatter(contacts_[block.contact], Kq, y);
  }
}

void ObstacleTerm::add_matrix(const Store& store, double scale, BlockMatrix& A) const {
  const auto& s = static_cast<const Touched&>(store);
  for (const Touched::Block& block : s.blocks) {
    const Contact& contact = contacts_[block.contact];
    const int* slot = slots_[block.contact].data();
    for (int i = 0; i < contact.count; ++i)
      for (int j = i; j < contact.count; ++j, ++slot)
        for (int r = 0; r < D_; ++r)
          for (int c = 0; c < D_; ++c) A.block(*slot)[r * D_ + c] += scale * block.K(3 * (1 + i) + r, 3 * (1 + j) + c);
  }
}

void ObstacleTerm::add_diagonal(const Store& store, double scale, Eigen::VectorXd& d) const {
  const auto& s = static_cast<const Touched&>(store);
  for (const Touched::Block& block : s.blocks) scatter(contacts_[block.contact], scale * block.K.diagonal(), d);
}

void ObstacleTerm::couple(Coupling& coupling) const {
  for (const Contact& contact : contacts_) coupling.add(std::span(contact.node.data(), contact.count));
}

void ObstacleTerm::bind(const BlockPattern& pattern) {
  for (const Contact& contact : contacts_) {
    std::array<int, 6> slots{};
    int k = 0;
    for (int i = 0; i < contact.count; ++i)
      for (int j = i; j < contact.count; ++j) slots[k++] = pattern.slot(contact.node[i], contact.node[j]);
    slots_.push_back(slots);
  }
}

bool ObstacleTerm::drives(double t) const {
  return obstacle_.friction > 0 && !obstacle_.motion.empty() && !is_gone(t) && Pose(obstacle_.motion, t).moves();
}

double ObstacleTerm::largest_step(const Motion& motion, const Eigen::VectorXd& dx, Store&) const {
  if (is_gone(motion.t)) return 1;
  double largest = 1;
  std::visit(
      [&](const auto& here) {
        const auto by = nodes_.count > 0 ? shape_at(here, nodes_, dx, D_) : still(here);
        for (const Contact& contact : contacts_)
          largest = std::min(largest, way_to(here, by, patch(motion.x, contact), patch(dx, contact), dh_));
      },
      shape(motion.x));
  return largest;
}

}  // namespace sim
