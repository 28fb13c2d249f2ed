#include "sim/time/implicit.h"

#include <cmath>
#include <limits>

#include "sim/solve/stopwatch.h"
#include "sim/solve/turning.h"
#include "sim/term/untangle.h"
#include "sim/time/finish.h"

namespace sim {

namespace {

constexpr int most_halvings = 4;  // of a step: 16 parts at most

// Where an iteration may start.
enum class Guess { stay, flight, turned, carried_on };

}  // namespace

ImplicitStepper::ImplicitStepper(const Model& model, const Scheme& scheme, int threads,
                                 std::function<bool()> interrupted)
    : model_(model),
      scheme_(scheme),
      newton_(model, threads, std::move(interrupted)),
      limit_(model, newton_.tangent()),
      may_gain_(!scheme.is_static && newton_.tangent().limits_moves()),
      begin_(most_halvings + 1) {
  // What a scheme has no use for is zero: a static step leaves a state without a force, not with what memory held.
  for (Eigen::VectorXd* v : {&x_star_, &v_start_, &way_, &target_, &turned_, &impulse_, &x_first_, &v_first_,
                             &force_first_, &x_, &v_, &x_lagged_, &v_lagged_, &force_, &barrier_impulse_})
    v->setZero(model.dofs());
}

// Puts the start of the iteration into x_, v_: free flight, the same with bodies that turn, the acceleration of the
// step before carried on, or x_n, whichever has the lowest potential. No iterate has a higher one, so that even an
// iteration which is cut short ends no higher than where the step began. Returns that potential, where it was
// evaluated.
std::optional<double> ImplicitStepper::guess(const StageProblem& problem, const Scheme& scheme, double h) {
  const Motion motion{x_, v_, problem.t, problem.gh == 0 ? 0 : 1 / problem.gh, problem.barriers};
  if (scheme.is_static || scheme.one_iteration) {
    x_ = next_.x;
    if (problem.gh == 0)
      v_.setZero();
    else
      v_ = (x_ - x_star_) / problem.gh;
    model_.pins.prescribe(problem.t, x_, v_);
    if (scheme.is_static) limit_guess(problem);
    return {};
  }
  const auto aim = [&](Guess start) {
    if (start == Guess::flight)
      v_ = v_start_;
    else if (start == Guess::turned)
      v_ = (next_.x + turned_ - x_star_) / problem.gh;
    else if (start == Guess::carried_on)
      v_ = v_start_ + (problem.gh / h) * (next_.v - next_.v_before);
    else
      v_ = (next_.x - x_star_) / problem.gh;
    x_ = x_star_ + problem.gh * v_;
    model_.pins.prescribe(problem.t, x_, v_);
  };
  Guess best = Guess::stay, last = Guess::stay;
  double lowest = std::numeric_limits<double>::infinity(), staying = lowest;
  for (const Guess start : {Guess::stay, Guess::flight, Guess::turned, Guess::carried_on}) {
    if (start == Guess::carried_on && next_.v_before.size() == 0) continue;
    if (start == Guess::turned && !flight_turns(problem)) continue;
    last = start;
    aim(start);
    const double potential = newton_.potential(problem, motion);
    if (start == Guess::stay) staying = potential;
    if (potential < lowest) {
      lowest = potential;
      best = start;
    }
  }
  if (best != last) aim(best);
  // What is cut ends close to what it would have hit, perhaps higher than it began.
  if (limit_guess(problem)) lowest = newton_.potential(problem, motion);
  if (std::isfinite(lowest) && lowest <= staying) return lowest;
  aim(Guess::stay);
  limit_guess(problem);
  return {};
}

// Into turned_: free flight from x_n, in which bodies turn by so much that they would be stretched along a straight
// way.
bool ImplicitStepper::flight_turns(const StageProblem& problem) {
  constexpr double least = 0.05;  // radian: 1e-3 of strain
  way_ = x_star_ + problem.gh * v_start_ - next_.x;
  return turn_along(model_, newton_.tangent().free(), least, next_.x, way_, turned_);
}

// The start of the iteration is a move from x_n like every other: it ends before what it would pass through, prescribed
// components as well. True: it was cut.
bool ImplicitStepper::limit_guess(const StageProblem& problem) {
  way_ = x_ - next_.x;
  const double limit = newton_.tangent().largest_step({next_.x, next_.v, problem.t, 0}, way_);
  if (limit >= 1) return false;
  x_ = next_.x + (step_share * limit) * way_;
  if (problem.gh == 0) return true;
  v_ = (x_ - x_star_) / problem.gh;
  model_.pins.prescribe(problem.t, way_, v_);
  return true;
}

bool ImplicitStepper::take_stage(const Scheme& scheme, const Stage& stage, int number, double h, double t_begin,
                                 StepReport& report) {
  const Eigen::VectorXd* x[] = {&next_.x, &next_.x_before, &x_first_};
  const Eigen::VectorXd* v[] = {&next_.v, &next_.v_before, &v_first_};
  const Eigen::VectorXd* f[] = {&next_.force, nullptr, &force_first_};
  x_star_.setZero();
  v_start_.setZero();
  impulse_.setZero();
  for (int k = 0; k < source_count; ++k) {
    if (stage.c[k] != 0) {
      x_star_ += stage.c[k] * *x[k];
      v_start_ += stage.c[k] * *v[k];
    }
    if (stage.d[k] != 0) {
      x_star_ += (h * stage.d[k]) * *v[k];
      impulse_ += (h * stage.d[k]) * *f[k];
    }
  }
  if (stage.c[first_stage] != 0) impulse_ -= stage.c[first_stage] * barrier_impulse_;
  const StageProblem problem{x_star_,
                             v_start_,
                             impulse_,
                             scheme.is_static ? 0 : stage.g * h,
                             t_begin + stage.end * h,
                             target_,
                             scheme.one_iteration,
                             stage.barriers()};
  model_.pins.prescribe(problem.t, target_, v_);
  const std::optional<double> start = guess(problem, scheme, h);
  if (!newton_.solve(problem, start, x_, v_, report)) return false;
  // What was frozen at the step's start cost an order of accuracy; frozen at the stage's solution it does not.
  const int again = newton_.tangent().lags() && !scheme.one_iteration ? model_.solver.lag_iterations : 0;
  for (int k = 0; k < again; ++k) {
    x_lagged_ = x_;
    v_lagged_ = v_;
    const Motion lagged{x_lagged_, v_lagged_, problem.t, 0};
    newton_.tangent().begin_step(lagged);
    if (!newton_.solve(problem, {}, x_, v_, report)) return false;
  }
  find_force(problem);
  if (number == 0 && scheme.stages.size() > 1) {
    x_first_ = x_;
    v_first_ = v_;
    force_first_ = force_;
  }
  leave_out_barriers(problem);
  return true;
}

// The force that the stage balanced, from its own equation (not evaluated anew: that would amplify what is left of the
// residual by the stiffness).
void ImplicitStepper::find_force(const StageProblem& problem) {
  if (problem.gh == 0) return;
  force_ = -impulse_;
  x_star_ = v_ - v_start_;
  for (const Mass& mass : model_.masses) mass.add_product(1, x_star_, force_, model_.D);
  force_ /= problem.gh;
}

// The next step's share of the force is without them; what they did in a first stage is known to the second.
void ImplicitStepper::leave_out_barriers(const StageProblem& problem) {
  if (problem.gh == 0 || !newton_.tangent().limits_moves()) return;
  newton_.tangent().barrier_forces({x_, v_, problem.t, 1 / problem.gh, problem.barriers}, barrier_impulse_);
  force_ -= barrier_impulse_;
  barrier_impulse_ *= problem.gh;
}

void ImplicitStepper::finish(const Scheme& scheme, const Motion& begin, double t_end) {
  next_.x_before = begin.x;
  next_.v_before = begin.v;
  if (scheme.extrapolate) {
    next_.x = 2 * x_ - next_.x_before;
    next_.v = 2 * v_ - next_.v_before;
  } else {
    next_.x = x_;
    next_.v = v_;
  }
  if (scheme.is_static) next_.v.setZero();
  model_.pins.prescribe(t_end, next_.x, next_.v);
  next_.force = force_;
}

// The step before has the same length only where no step is halved.
const Scheme& ImplicitStepper::scheme_of(const Interval& interval, const StepReport& report) const {
  if (report.braked) return *find_scheme("backward-euler");
  const bool starts = !scheme_.first_step.empty() && (next_.x_before.size() == 0 || interval.depth > 0);
  return starts ? *find_scheme(scheme_.first_step) : scheme_;
}

// next_ from `begin` over the interval; false where the equations are not solved.
bool ImplicitStepper::attempt(const Interval& interval, const Scheme& asked, const State& begin_state,
                              StepReport& report) {
  const auto& [t, t_end, h, depth] = interval;
  const bool released = model_.pins.released(t_end) != model_.pins.released(t);
  const Motion begin{begin_state.x, begin_state.v, t, 0};
  if (released) next_.kept.what = 0;
  newton_.begin_step(begin, t_end, next_.kept);
  // What untangles leaps.
  const bool leaps = !asked.is_static && UntangleTerm::draws(newton_.tangent().stores());
  const Scheme& scheme = leaps ? *find_scheme("backward-euler") : asked;
  if (next_.force.size() == 0 || released) {
    next_.force.resize(model_.dofs());
    newton_.tangent().forces({begin_state.x, begin_state.v, t, 0, 0}, next_.force);
    ++report.force_evaluations;
  }
  report.converged = true;
  for (std::size_t k = 0; k < scheme.stages.size(); ++k)
    if (!take_stage(scheme, scheme.stages[k], static_cast<int>(k), h, t, report)) return false;
  finish(scheme, begin, t_end);
  newton_.keep(next_.kept);
  return report.converged;
}

// Moves next_ over the interval, in halves where it must be. False, with report.failure: it cannot be done.
bool ImplicitStepper::advance(const Interval& interval, StepReport& report) {
  const auto& [t, t_end, h, depth] = interval;
  const bool converged_before = report.converged;
  State& begin = begin_[depth];
  begin = next_;
  const auto solved = [&](const Scheme& scheme) {
    if (!attempt(interval, scheme, begin, report)) return false;
    report.converged = converged_before;
    return true;
  };
  const Scheme &own = scheme_of(interval, report), &euler = *find_scheme("backward-euler");
  if (solved(own)) return true;
  if (report.interrupted) return false;
  if (model_.solver.on_failure == OnFailure::stop && report.failure.empty())
    report.failure = "the step did not converge: " + std::string(report.reason);
  if (model_.solver.on_failure != OnFailure::split || scheme_.is_static) return report.failure.empty();
  // What round-off ended is as good as solved.
  if (report.failure.empty() && !newton_.stuck() && !newton_.cut_short()) return true;
  // Iterations that got on, but were not given the time, would get on no faster in shorter steps. Where the finest part
  // fails, the other parts of the step are not tried finer than they are. What fails then is taken by backward Euler,
  // which asks for no force and no stage from before: its iterates only lower the energy.
  in_vain_ = in_vain_ || depth == most_halvings || (report.failure.empty() && !newton_.stuck());
  if (in_vain_ && &own == &euler) return report.failure.empty();
  next_ = begin;
  report.converged = converged_before;
  report.failure.clear();
  if (in_vain_) return solved(euler) || report.failure.empty();
  ++report.splits;
  const double middle = t + h / 2;
  return advance({t, middle, h / 2, depth + 1}, report) && advance({middle, t_end, h / 2, depth + 1}, report);
}

StepReport ImplicitStepper::step(State& state) {
  StepReport report;
  report.step = state.step + 1;
  Stopwatch watch(report.seconds);
  const Interval whole{model_.t(state.step), model_.t(state.step + 1), model_.h(), 0};
  const auto take = [&] {
    next_ = state;
    in_vain_ = false;
    report.converged = true;
    return advance(whole, report);
  };
  bool taken = take();
  const auto gains = [&] {
    return taken && report.converged && may_gain_ && limit_.gains(state, whole.t, next_, whole.t_end);
  };
  if (gains()) {
    report.braked = true;
    if (scheme_.order > 1) taken = take();
    if (gains())
      limit_.brake(state, whole.t, next_, whole.t_end);
    else if (taken)
      limit_.settle(next_, whole.t_end);
  }
  if (!taken) {
    measure_J(model_, newton_.tangent(), state, report);
    return report;
  }
  if (!report.converged && !scheme_.is_static) limit_.calm(state, whole.t, next_, whole.t_end);
  next_.x_before = state.x;
  next_.v_before = state.v;
  ++next_.step;
  if (finish_step(model_, newton_.tangent(), next_, report)) std::swap(state, next_);
  return report;
}

}  // namespace sim
