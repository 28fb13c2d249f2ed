#include "sim/solve/newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/solve/exactness.h"
#include "sim/solve/progress.h"
#include "sim/solve/stopwatch.h"

namespace sim {

namespace {

constexpr double linear_tolerance = 1e-2;  // |residual of the linear solve| / |right-hand side|
constexpr double chord = 0.1;              // |residual| / |the one before| down to which the tangent is kept
constexpr double force_noise = 1e-15;  // round-off of a body's forces at rest, relative to E V/L: not to be followed

}  // namespace

Newton::Newton(const Model& model, int threads, std::function<bool()> interrupted)
    : model_(model),
      interrupted_(std::move(interrupted)),
      fix_(model.solver.definiteness),
      pure_(model.solver.newton == NewtonKind::pure),
      tangent_(model, threads),
      linear_(make_linear_solver(model)),
      f_(model.dofs()),
      residual_(model.dofs()),
      dx_(model.dofs()),
      x_from_(model.dofs()),
      v_from_(model.dofs()),
      difference_(model.dofs()),
      product_(model.dofs()),
      turned_(model.dofs()),
      way_(Eigen::VectorXd::Zero(model.dofs())),
      v_given_(model.dofs()),
      still_(Eigen::VectorXd::Zero(model.dofs())) {}

void Newton::begin_step(const Motion& start, double t_end, const KeptFactor& kept) {
  if (model_.pins.released(t_end) != tangent_.epoch()) {
    model_.pins.mark(t_end, tangent_.free());
    tangent_.set_epoch(model_.pins.released(t_end));
  }
  stuck_ = cut_short_ = false;
  linear_->begin_step(tangent_, kept);
  tangent_.begin_step(start);
}

void Newton::keep(KeptFactor& kept) const {
  if (linear_->kept()) kept = *linear_->kept();
}

void Newton::inertia(const StageProblem& stage, const Eigen::VectorXd& v, Eigen::VectorXd& result) {
  difference_ = v - stage.v_start;
  result = -stage.impulse;
  for (const Mass& mass : model_.masses) mass.add_product(1, difference_, result, model_.D);
}

// 1/2 |v - v_start|_M^2 - (v - v_start) . impulse + U
double Newton::potential(const StageProblem& stage, const Motion& motion) {
  const double U = tangent_.energy(motion);
  if (stage.gh == 0) return U;
  inertia(stage, motion.v, product_);
  return 0.5 * difference_.dot(product_) - 0.5 * difference_.dot(stage.impulse) + U;
}

// x = x* + g h v on the free components; a static problem, and prescribed components on their way, move x itself.
// Velocities change with positions on both: dv = dx/(g h).
void Newton::move(const StageProblem& stage, double a, Eigen::VectorXd& x, Eigen::VectorXd& v) const {
  if (stage.gh == 0) {
    x = x_from_ + a * dx_;
    return;
  }
  const auto& free = tangent_.free();
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    v[i] = v_from_[i] + (a / stage.gh) * dx_[i];
    x[i] = free[i] != 0 ? stage.x_star[i] + stage.gh * v[i] : x_from_[i] + a * dx_[i];
  }
}

bool Newton::is_interrupted(StepReport& report) const {
  if (!interrupted_ || !interrupted_()) return false;
  report.interrupted = true;
  report.failure = "interrupted";
  return true;
}

// f - (M (v - v_start) - impulse)/(g h), from the forces in f_
void Newton::form_residual(const StageProblem& stage, const Motion& motion) {
  residual_ = f_;
  if (stage.gh != 0) {
    inertia(stage, motion.v, product_);
    residual_ -= motion.dv_dx * product_;
  }
  residual_.array() *= tangent_.free().array();
}

// Whether the tangent of the iteration before is good for another: it left little of the residual. Then residual_ is
// that of the motion.
bool Newton::tangent_serves(const StageProblem& stage, const Motion& motion, StepReport& report) {
  const Stopwatch watch(report.seconds_assemble);
  tangent_.forces(motion, f_);
  ++report.force_evaluations;
  form_residual(stage, motion);
  return residual_.norm() <= chord * residual_norm_;
}

// The Newton direction dx_ from the residual, with the matrix made definite as `first` says, then otherwise; after a
// full step with the matrix of the iteration before, where it serves. False: a value is not finite.
bool Newton::direction(const StageProblem& stage, const Motion& motion, Definiteness first, bool full_step_before,
                       double tolerance, StepReport& report) {
  const Motion still{motion.x, still_, motion.t, 0, motion.barriers};
  const Motion& seen = way_kind_ == Way::slides ? still : motion;
  const double rate = motion.dv_dx;
  const Definiteness definite = fix_ == Definiteness::none ? Definiteness::clamp : fix_;
  is_singular_ = false;
  kept_tangent_ = !pure_ && full_step_before && first == made_ && tangent_serves(stage, motion, report);
  for (Definiteness fix = first;; fix = definite, kept_tangent_ = false) {
    Stopwatch watch(report.seconds_assemble);
    if (!kept_tangent_) {
      tangent_.linearise(seen, rate * rate, fix, f_);
      ++report.force_evaluations;
      form_residual(stage, motion);
      made_ = fix;
    }
    if (way_kind_ != Way::none) {
      tangent_.multiply(way_, product_);
      residual_ -= product_;
    }
    residual_norm_ = residual_.norm();
    watch.stop();
    if (!std::isfinite(residual_norm_)) return false;
    if (residual_norm_ * model_.node_size.minCoeff() <= force_noise * model_.energy_scale) {
      dx_.setZero();
      return true;
    }

    Stopwatch solve_watch(report.seconds_solve);
    const LinearResult linear = linear_->solve(tangent_, residual_, tolerance, dx_);
    report.linear += linear.iterations;
    report.factorisations += linear.factorisations;
    report.no_factor = report.no_factor || linear.no_factor;
    is_singular_ = pure_ && !linear.solved;
    if (linear.positive_definite) return dx_.allFinite();
    // The exact tangent is not positive definite here: clamped, it is, but for round-off. Where even that fails, down
    // the slope by the diagonal.
    if (fix == Definiteness::none) continue;
    tangent_.diagonal(dx_);
    dx_ = residual_.cwiseQuotient(dx_);
    return dx_.allFinite();
  }
}

// As many as the scene allows a stage. A step that is halved again and again has twice as many in all, and some for
// each part that is left: parts that get nowhere would take hours otherwise.
int Newton::most_iterations(const StepReport& report) const {
  constexpr int least = 20;
  const int allowed = model_.solver.max_iterations;
  return std::clamp(2 * allowed - report.newton, std::min(least, allowed), allowed);
}

// Of dx_, as solver.tolerance counts it: body sizes per second, in statics body sizes.
double Newton::largest_increment(const StageProblem& stage) const {
  const double per_second = stage.gh == 0 ? 1 : 1 / stage.gh;
  double largest = 0;
  for (Eigen::Index node = 0; node < model_.node_count; ++node)
    largest = std::max(largest, dx_.segment(node * model_.D, model_.D).norm() * per_second / model_.node_size[node]);
  return largest;
}

Newton::Move Newton::whole_step(const StageProblem& stage, Eigen::VectorXd& x, Eigen::VectorXd& v) {
  x_from_ = x;
  v_from_ = v;
  move(stage, 1, x, v);
  return {1, 0, 0};
}

bool Newton::solve(const StageProblem& stage, std::optional<double> start, Eigen::VectorXd& x, Eigen::VectorXd& v,
                   StepReport& report) {
  if (model_.node_count == 0) return true;  // a scene without bodies
  const Motion motion{x, v, stage.t, stage.gh == 0 ? 0 : 1 / stage.gh, stage.barriers};
  const int most = stage.one_iteration ? 1 : most_iterations(report);
  // A single iteration has no later one to mend what its linear solve left.
  const double linear = stage.one_iteration ? std::min(1e-6, model_.solver.tolerance) : linear_tolerance;
  if (has_way_to_go(stage, x)) {
    if (!bring_prescribed(stage, motion, x, v, report)) return false;
    start.reset();
  }
  const bool takes_whole_steps = stage.one_iteration || (pure_ && fix_ == Definiteness::none);
  double potential_here = 0;
  if (!takes_whole_steps) potential_here = start ? *start : potential(stage, motion);
  Exactness exactness(fix_, pure_);
  Progress progress;
  bool full_step_before = false;
  int k = 0;
  for (; k < most; ++k) {
    if (is_interrupted(report)) return false;
    const Definiteness first = exactness.next();
    if (!direction(stage, motion, first, full_step_before, linear, report)) {
      report.failure = "the forces or the Newton direction are not finite";
      return false;
    }
    if (is_singular_) {
      report.reason = "the matrix is singular";
      break;
    }
    ++report.newton;
    const Move step =
        takes_whole_steps ? whole_step(stage, x, v) : line_search(stage, motion, potential_here, x, v, report);
    report.increment = largest_increment(stage);
    if (stage.one_iteration || (step.a == 1 && report.increment <= model_.solver.tolerance)) return true;
    if (step.a == 0 && !exactness.exact() && !kept_tangent_) {
      report.reason = "no step along the Newton direction lowers the potential";
      stuck_ = true;
      break;
    }
    // Whole steps need not lower anything on their way.
    const Progress::Kind made =
        takes_whole_steps ? Progress::Kind::made
                          : progress.look(step.fall, step.promised, report.increment, noise_of(potential_here));
    if (made != Progress::Kind::made) {
      stuck_ = made == Progress::Kind::none;
      report.reason =
          stuck_ ? "the iteration makes no progress" : "round-off hides what is left of the potential's fall";
      break;
    }
    full_step_before = step.a == 1;
    exactness.look(made_ == first, step.a >= 1, step.fall, report.increment);
  }
  report.converged = false;
  if (k == most) {
    report.reason = "solver.max_iterations reached";
    cut_short_ = true;
  }
  return true;
}

}  // namespace sim
