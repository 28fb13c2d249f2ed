#include "sim/term/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "sim/term/contact_store.h"

namespace sim {

namespace {

constexpr double margin = 1e-3;  // of the reach: round-off of a way, and small moves without a new search
// Of a gap, or of the barrier's width where that is less, a move leaves so much. What slides along a curved surface
// leaves it, or runs into it, by the square of its way: where moves end close to a surface, those after them are short,
// while the barrier's tangent opens a gap to no more than twice its width at a time.
constexpr double kept_gap = 0.2;

}  // namespace

ContactTerm::ContactTerm(Input input, const Eigen::VectorXd& X)
    : in_(std::move(input)),
      broad_phase_(in_.skin,
                   [&] {
                     Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(in_.skin.node.size()));
                     const int D = in_.skin.D;
                     for (Eigen::Index p = 0; p < x.cols(); ++p)
                       x.col(p).head(D) = X.segment(static_cast<Eigen::Index>(in_.skin.node[p]) * D, D);
                     return x;
                   }()),
      reach_(0) {
  for (const Couple& couple : in_.couples) reach_ = std::max(reach_, couple.dh + couple.xi);
}

TermInfo ContactTerm::info() const {
  std::ostringstream what;
  what << in_.skin.node.size() << " points, " << in_.skin.faces.size() << (in_.skin.D == 2 ? " edges" : " faces")
       << ", " << in_.couples.size() << (in_.couples.size() == 1 ? " pair" : " pairs");
  for (const Couple& couple : in_.couples)
    if (&couple == &in_.couples.front() || couple.dh != in_.couples.front().dh) what << ", from " << couple.dh << " m";
  what << ", stiffness " << in_.couples.front().kappa << " Pa, offset " << in_.couples.front().xi << " m, friction "
       << in_.friction;
  return {"contact " + in_.name, what.str()};
}

std::unique_ptr<Term::Store> ContactTerm::make_store(int threads) const {
  auto store = std::make_unique<Contacts>();
  store->threads = threads;
  store->x = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(in_.skin.node.size()));
  return store;
}

void ContactTerm::place(const Eigen::VectorXd& x, Contacts& s) const {
  const int D = in_.skin.D;
  for (std::size_t p = 0; p < in_.skin.node.size(); ++p)
    s.x.col(static_cast<Eigen::Index>(p)).head(D) = x.segment(static_cast<Eigen::Index>(in_.skin.node[p]) * D, D);
}

// Candidates for the points at s.x, found anew only where one has left its box.
void ContactTerm::cover(Contacts& s) const {
  const std::size_t n = in_.skin.node.size();
  bool inside = s.boxes.points.size() == n;
  for (std::size_t p = 0; inside && p < n; ++p)
    inside = s.boxes.points[p].contains(s.x.col(static_cast<Eigen::Index>(p)));
  if (inside) return;
  s.boxes.points.resize(n);
  for (std::size_t p = 0; p < n; ++p) {
    const Vec3 x = s.x.col(static_cast<Eigen::Index>(p)), grow = Vec3::Constant(margin * reach_);
    s.boxes.points[p] = Bounds(x - grow, x + grow);
  }
  broad_phase_.find(in_.couples, std::numeric_limits<std::size_t>::max(), s.boxes, s.candidates);
}

// The touches at the motion, gathered; false where two primitives are at their offset or nearer.
bool ContactTerm::find_touches(const Motion& motion, Contacts& s) const {
  place(motion.x, s);
  s.touches.clear();
  if (is_gone(motion.t)) return true;
  if (!s.x.allFinite()) return false;
  cover(s);
  for (const Candidate& candidate : s.candidates)
    if (!add_touches(in_.skin, in_.couples, candidate, s.x, s.touches)) return false;
  gather(s.touches);
  return true;
}

void ContactTerm::begin_step(const Motion& start, Store& store) const {
  auto& s = static_cast<Contacts&>(store);
  s.sticks.clear();
  if (in_.friction == 0 || !find_touches(start, s)) return;
  for (const Touch& touch : s.touches) {
    const TouchPotential at(touch, in_.couples[touch.couple], s.x);
    if (at.push() > 0) s.sticks.emplace_back(at, in_.friction);
  }
}

Vec3 ContactTerm::slip(const Stick& stick, const Eigen::VectorXd& v) const {
  const int D = in_.skin.D;
  Vec3 w = Vec3::Zero();
  for (int i = 0; i < stick.count; ++i)
    w.head(D) += stick.c[i] * v.segment(static_cast<Eigen::Index>(in_.skin.node[stick.point[i]]) * D, D);
  return slip_of(w, stick.n);
}

double ContactTerm::energy(const Motion& motion, Store& store) const {
  auto& s = static_cast<Contacts&>(store);
  if (!find_touches(motion, s)) return std::numeric_limits<double>::infinity();
  double U = 0;
  for (const Touch& touch : s.touches) U += touch_energy(touch, in_.couples[touch.couple], s.x);
  if (motion.dv_dx != 0 && !is_gone(motion.t))
    for (const Stick& stick : s.sticks)
      U += stick.strength * SmoothFriction(slip(stick, motion.v).norm(), in_.eps).f0 / motion.dv_dx;
  return U;
}

void ContactTerm::scatter(const std::array<int, 4>& points, int count, const PairVector& force,
                          Eigen::VectorXd& f) const {
  const int D = in_.skin.D;
  for (int i = 0; i < count; ++i)
    f.segment(static_cast<Eigen::Index>(in_.skin.node[points[i]]) * D, D) += force.segment(3 * i, D);
}

void ContactTerm::add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const {
  auto& s = static_cast<Contacts&>(store);
  find_touches(motion, s);
  for (const Touch& touch : s.touches)
    scatter(touch.point, points_in(touch), -TouchPotential(touch, in_.couples[touch.couple], s.x).gradient(), f);
  if (is_gone(motion.t)) return;
  for (const Stick& stick : s.sticks)
    scatter(stick.point, stick.count,
            spread(stick.shares(), Vec3(-stick.strength * slip_gradient(slip(stick, motion.v), in_.eps))), f);
}

void ContactTerm::linearise(const Motion& motion, Definiteness fix, Store& store, Eigen::VectorXd& f) const {
  auto& s = static_cast<Contacts&>(store);
  add_forces(motion, store, f);
  const std::size_t sticks = is_gone(motion.t) ? 0 : s.sticks.size();
  s.blocks.resize(s.touches.size() + sticks);
#pragma omp parallel for schedule(static) num_threads(s.threads)
  for (std::size_t k = 0; k < s.touches.size(); ++k) {
    const Touch& touch = s.touches[k];
    s.blocks[k].point = touch.point;
    s.blocks[k].count = points_in(touch);
    // A count below 0, in a hollow, pulls: a negative part, kept only in the exact tangent.
    if (touch.weight < 0 && fix != Definiteness::none)
      s.blocks[k].K.setZero();
    else
      s.blocks[k].K = TouchPotential(touch, in_.couples[touch.couple], s.x).tangent(fix);
  }
  for (std::size_t k = 0; k < sticks; ++k) {
    const Stick& stick = s.sticks[k];
    const Eigen::Matrix3d K = stick.strength * motion.dv_dx * slip_tangent(slip(stick, motion.v), stick.n, in_.eps);
    s.blocks[s.touches.size() + k] = {stick.point, stick.count, spread(stick.shares(), K)};
  }
}

void ContactTerm::add_product(const Store& store, double scale, const Eigen::VectorXd& p, Eigen::VectorXd& y) const {
  const auto& s = static_cast<const Contacts&>(store);
  const int D = in_.skin.D;
  for (const Contacts::Block& block : s.blocks) {
    PairVector q = PairVector::Zero();
    for (int i = 0; i < block.count; ++i)
      q.segment(3 * i, D) = p.segment(static_cast<Eigen::Index>(in_.skin.node[block.point[i]]) * D, D);
    const int n = 3 * block.count;
    PairVector Kq = PairVector::Zero();
    Kq.head(n) = scale * (block.K.topLeftCorner(n, n) * q.head(n));
    scatter(block.point, block.count, Kq, y);
  }
}

void ContactTerm::add_matrix(const Store& store, double scale, BlockMatrix& A) const {
  const auto& s = static_cast<const Contacts&>(store);
  const int D = in_.skin.D;
  for (const Contacts::Block& block : s.blocks)
    for (int i = 0; i < block.count; ++i)
      for (int j = 0; j < block.count; ++j) {
        const int row = in_.skin.node[block.point[i]], column = in_.skin.node[block.point[j]];
        if (row > column || column >= in_.first_given) continue;
        double* to = A.find(row, column);
        for (int r = 0; r < D; ++r)
          for (int c = 0; c < D; ++c) to[r * D + c] += scale * block.K(3 * i + r, 3 * j + c);
      }
}

void ContactTerm::add_diagonal(const Store& store, double scale, Eigen::VectorXd& d) const {
  const auto& s = static_cast<const Contacts&>(store);
  for (const Contacts::Block& block : s.blocks) scatter(block.point, block.count, scale * block.K.diagonal(), d);
}

void ContactTerm::add_pairs(const Store& store, std::vector<NodePair>& pairs) const {
  const auto& s = static_cast<const Contacts&>(store);
  for (const Contacts::Block& block : s.blocks)
    for (int i = 0; i < block.count; ++i)
      for (int j = 0; j < block.count; ++j) {
        const int row = in_.skin.node[block.point[i]], column = in_.skin.node[block.point[j]];
        if (row < column && column < in_.first_given) pairs.push_back({row, column});
      }
}

// Looks for candidates on the whole way first, on ever shorter parts of it where they would be too many.
double ContactTerm::largest_step(const Motion& motion, const Eigen::VectorXd& dx, Store& store) const {
  constexpr std::size_t most_each = 64;  // candidates a point, on average: a wild way must not fill the memory
  if (is_gone(motion.t)) return 1;
  auto& s = static_cast<Contacts&>(store);
  const auto n = static_cast<Eigen::Index>(in_.skin.node.size());
  place(dx, s);
  s.way = s.x;
  place(motion.x, s);
  double part = 1;
  s.boxes.points.resize(static_cast<std::size_t>(n));
  const Vec3 grow = Vec3::Constant(margin * reach_);
  for (;; part /= 2) {
    for (Eigen::Index p = 0; p < n; ++p) {
      const Vec3 from = s.x.col(p), to = from + part * s.way.col(p);
      s.boxes.points[static_cast<std::size_t>(p)] = Bounds(from.cwiseMin(to) - grow, from.cwiseMax(to) + grow);
    }
    const bool last = part < 1e-3;
    const std::size_t most = last ? std::numeric_limits<std::size_t>::max() : most_each * static_cast<std::size_t>(n);
    if (broad_phase_.find(in_.couples, most, s.boxes, s.candidates)) break;
  }
  double least = part;
#pragma omp parallel for schedule(static) reduction(min : least) num_threads(s.threads)
  for (std::size_t k = 0; k < s.candidates.size(); ++k) {
    const Candidate& candidate = s.candidates[k];
    int points[4];
    Vec3 x[4], p[4];
    const int count = points_of(in_.skin, candidate, points);
    for (int i = 0; i < count; ++i) {
      x[i] = s.x.col(points[i]);
      p[i] = s.way.col(points[i]);
    }
    const Couple& couple = in_.couples[candidate.couple];
    const double gap = sim::nearest(candidate.kind, x).d - couple.xi;
    least = std::min(least, step_limit(candidate.kind, x, p, couple.xi + kept_gap * std::min(gap, couple.dh), part));
  }
  return least;
}

}  // namespace sim
