#include "sim/time/step_watch.h"

#include <algorithm>
#include <cmath>

#include "sim/time/stable_step.h"

namespace sim {
namespace {

// Steps from one look to the next. In few numbers the fastest motion is not much faster than the body as a whole, which
// then deforms far in a few steps.
constexpr std::int64_t interval = 16, interval_in_basis = 4;
constexpr int first_iterations = 12, iterations = 2;
constexpr double in_hand = 0.9;     // of the limit: it may fall until the next look
constexpr std::int64_t most = 100;  // parts; a body that needs more is as good as crushed
// Of the smallest body: far above the round-off of forces, far below what changes K
constexpr double probe = 1e-7;
// Of the largest number of the last shape, in random signs: another part of the body may have become the fastest.
constexpr double renewed = 0.3;

}  // namespace

StepWatch::StepWatch(const Model& model, TangentOperator& tangent, MassSolve& mass)
    : model_(model),
      tangent_(tangent),
      mass_(mass),
      still_(Eigen::VectorXd::Zero(model.dofs())),
      f_(model.dofs()),
      difference_(model.dofs()),
      product_(model.dofs()) {}

bool StepWatch::is_due(const State& state) const {
  return state.fastest.size() == 0 || state.step % (model_.dense ? interval_in_basis : interval) == 0;
}

// p becomes M^{-1} K p, its largest number 1; returns by how much it grew. Norms are the largest number, as the fastest
// vibration of a mesh is that of a few elements, whose share of a sum over all nodes is small.
double StepWatch::iterate(double t, const State& state, Eigen::VectorXd& p) {
  const double e = probe * model_.node_size.minCoeff();
  moved_ = state.x + e * p;
  tangent_.forces({moved_, still_, t, 0}, difference_);
  difference_ = (f_ - difference_) / e;
  mass_.solve(difference_, tangent_.free(), product_);
  const double growth = product_.lpNorm<Eigen::Infinity>();
  if (growth > 0 && std::isfinite(growth)) p = product_ / growth;
  return growth;
}

double StepWatch::damping_rate(double t, const State& state, const Eigen::VectorXd& p) {
  tangent_.forces({state.x, p, t, 0}, difference_);
  difference_ = f_ - difference_;
  mass_.solve(difference_, tangent_.free(), product_);
  return product_.lpNorm<Eigen::Infinity>();
}

void StepWatch::look(double t, State& state, StepReport& report) {
  const bool first = state.fastest.size() == 0;
  if (first) state.fastest.setZero(model_.dofs());
  Eigen::VectorXd& p = state.fastest;
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    const double sign = std::sin(12.9898 * static_cast<double>(i + 1) + static_cast<double>(state.step));
    p[i] = (p[i] + std::copysign(renewed, sign)) * tangent_.free()[i];
  }
  const double largest = p.lpNorm<Eigen::Infinity>();
  if (!(largest > 0)) return;
  p /= largest;
  tangent_.forces({state.x, still_, t, 0}, f_);
  double omega2 = 0;
  const int count = first ? first_iterations : iterations;
  for (int k = 0; k < count; ++k) omega2 = iterate(t, state, p);
  const double limit = in_hand * stable_step(lacking * omega2, lacking * damping_rate(t, state, p));
  report.force_evaluations += count + 2;
  // Where forces are not finite the step itself will say so.
  if (!(limit > 0)) return;
  // Few numbers move as fast as the body as a whole does: steps that grew and shrank with it would feed its motion.
  const std::int64_t least = model_.dense ? state.parts : 1;
  state.parts = std::clamp<std::int64_t>(static_cast<std::int64_t>(std::ceil(model_.h() / limit)), least, most);
}

}  // namespace sim
