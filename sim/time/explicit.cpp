#include "sim/time/explicit.h"

#include "sim/solve/stopwatch.h"
#include "sim/time/finish.h"

namespace sim {

ExplicitStepper::ExplicitStepper(const Model& model, const Scheme& scheme, int threads)
    : model_(model), scheme_(scheme), tangent_(model, threads), mass_(model), a_(model.dofs()) {
  if (model.watches_step) watch_.emplace(model, tangent_, mass_);
}

void ExplicitStepper::kick(double s, const Eigen::VectorXd& f, Eigen::VectorXd& v, StepReport& report) {
  report.linear += mass_.solve(f, tangent_.free(), a_);
  v += s * a_;
}

void ExplicitStepper::advance(double t, double t_end, double h, StepReport& report) {
  const bool verlet = scheme_.kick == Kick::halves;
  tangent_.begin_step({next_.x, next_.v, t, 0});
  // Verlet ends a step with the forces at its end, which the next one starts with.
  if (!verlet || next_.force.size() == 0) {
    next_.force.resize(model_.dofs());
    tangent_.forces({next_.x, next_.v, t, 0}, next_.force);
    ++report.force_evaluations;
  }
  kick(verlet ? h / 2 : h, next_.force, next_.v, report);
  next_.x += h * next_.v;
  model_.pins.prescribe(t_end, next_.x, next_.v);
  if (verlet) {
    tangent_.forces({next_.x, next_.v, t_end, 0}, next_.force);
    ++report.force_evaluations;
    kick(h / 2, next_.force, next_.v, report);
  }
}

StepReport ExplicitStepper::step(State& state) {
  StepReport report;
  report.step = state.step + 1;
  Stopwatch watch(report.seconds);
  const double t = model_.t(state.step), t_end = model_.t(state.step + 1);
  next_ = state;
  const bool released = model_.pins.released(t_end) != tangent_.epoch();
  if (released) {
    model_.pins.mark(t_end, tangent_.free());
    tangent_.set_epoch(model_.pins.released(t_end));
  }
  if (watch_ && watch_->is_due(state)) {
    tangent_.begin_step({state.x, state.v, t, 0});
    watch_->look(t, next_, report);
  }
  const double h = model_.h() / static_cast<double>(next_.parts);
  for (std::int64_t k = 1; k <= next_.parts; ++k)
    advance(t + static_cast<double>(k - 1) * h, k == next_.parts ? t_end : t + static_cast<double>(k) * h, h, report);
  ++next_.step;
  if (finish_step(model_, tangent_, next_, report)) std::swap(state, next_);
  return report;
}

}  // namespace sim
