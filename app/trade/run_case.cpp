#include "app/trade/run_case.h"

#include <algorithm>

#include "app/base/other_load.h"
#include "app/base/stopwatch.h"
#include "app/base/text.h"
#include "sim/mesh/input_error.h"
#include "sim/stepper.h"
#include "sim/time/scheme.h"

namespace app {
namespace {

constexpr int repeats = 3;
constexpr std::size_t most_timed = 64;  // steps of a run whose times are kept

// One pass over the stretch.
class Pass {
 public:
  Pass(const Comparison& comparison, const TradeCase& which, const Simulation& simulation, const Interrupt& interrupt)
      : comparison_(comparison),
        system_(*simulation.system),
        interrupt_(interrupt),
        stepper_(
            sim::make_stepper(system_, sim::useful_threads(system_, options_of(comparison.options, which).threads))),
        state_(system_.initial_state()),
        steps_(comparison.stretch.last * system_.steps_per_frame()) {}

  // Fills in what the run shows. With a sampler the path is kept.
  void go(const Allowance& allowance, const sim::Sampler* sampler, CaseRun& run) {
    const Stopwatch watch;
    const double cpu_before = own_cpu_seconds();
    while (state_.step < steps_) {
      if (interrupt_.requested()) throw Interrupted{};
      const sim::StepReport report = timed_step();
      if (!report.failure.empty()) return fail(report, run);
      add(report, run);
      if (sampler && state_.step % (comparison_.stretch.stride * system_.steps_per_frame()) == 0)
        sim::add_frame(system_, state_, *sampler, run.path);
      const double so_far = watch.seconds(), whole = so_far / double(state_.step) * double(steps_);
      if (so_far > allowance.patience && whole > allowance.run) return give_up(whole, run);
    }
    run.status = CaseStatus::done;
    run.work.cpu = (own_cpu_seconds() - cpu_before) / system_.time(state_.step);
    per_simulated_second(run);
    keep_some(run);
  }

  // Its steps only.
  std::vector<sim::TimedStep> go(double seconds) {
    const Stopwatch watch;
    while (state_.step < steps_ && (watch.seconds() < seconds || timed_.size() < least_timed)) {
      if (interrupt_.requested()) throw Interrupted{};
      if (!timed_step().failure.empty()) break;
    }
    return timed_;
  }

  double seconds() const { return seconds_ + first_; }

 private:
  static constexpr std::size_t least_timed = 8;

  // CPU seconds do not pass while other programs have the core, wall seconds do; those of several threads add up. So
  // the less of both is nearer to what the step takes by itself.
  sim::StepReport timed_step() {
    const double cpu_before = own_cpu_seconds();
    const sim::StepReport report = stepper_->step(state_);
    const double seconds = std::min(report.seconds, own_cpu_seconds() - cpu_before);
    if (state_.step > 1 && report.failure.empty())
      timed_.push_back(
          {{1, double(report.force_evaluations), double(report.factorisations), double(report.linear)}, seconds});
    return report;
  }

  // As many as are kept, all along the way.
  void keep_some(CaseRun& run) const {
    const std::size_t stride = std::max<std::size_t>(1, (timed_.size() + most_timed - 1) / most_timed);
    for (std::size_t k = 0; k < timed_.size(); k += stride) run.timed.push_back(timed_[k]);
  }

  void add(const sim::StepReport& report, CaseRun& run) {
    (state_.step == 1 ? first_ : seconds_) += report.seconds;
    run.work.newton += report.newton;
    run.work.linear += report.linear;
    run.work.factorisations += report.factorisations;
    run.work.force_evaluations += report.force_evaluations;
    run.not_converged += report.converged ? 0 : 1;
  }

  void fail(const sim::StepReport& report, CaseRun& run) {
    run.status = CaseStatus::failed;
    run.reason = failure_text(system_, report);
    per_simulated_second(run);
  }

  void give_up(double whole, CaseRun& run) {
    run.status = CaseStatus::skipped;
    run.reason = formatted("would take about %.0f s", whole);
    run.estimate = whole;
  }

  void per_simulated_second(CaseRun& run) {
    const double simulated = system_.time(state_.step), timed = simulated - system_.step_seconds();
    run.work.seconds.push_back(timed > 0 ? seconds_ / timed : first_ / system_.step_seconds());
    if (!(simulated > 0)) return;
    for (double* count : {&run.work.newton, &run.work.linear, &run.work.factorisations, &run.work.force_evaluations})
      *count /= simulated;
    run.work.steps = double(state_.step) / simulated;
  }

  const Comparison& comparison_;
  const sim::System& system_;
  const Interrupt& interrupt_;
  std::unique_ptr<sim::Stepper> stepper_;
  sim::State state_;
  std::int64_t steps_;
  double first_ = 0, seconds_ = 0;  // of the first step, which warms up, and of all others
  std::vector<sim::TimedStep> timed_;
};

void describe(const Comparison& comparison, const Simulation& simulation, CaseRun& run) {
  run.id = case_id(comparison, simulation.identity, options_of(comparison.options, run.which).threads);
  run.training = simulation.basis_seconds;
  run.step = simulation.system->step_seconds();
  run.order = sim::find_scheme(simulation.document.scene.time.integrator)->order;
  run.dofs = simulation.system->counts().dofs;
}

}  // namespace

CaseRun run_case(const Comparison& comparison, const TradeCase& which, const Simulation& simulation,
                 const Allowance& allowance, const Interrupt& interrupt) {
  CaseRun run;
  run.which = which;
  run.path.dimension = comparison.points.dimension;
  describe(comparison, simulation, run);
  try {
    const sim::Sampler sampler(*simulation.system, comparison.points);
    Pass first(comparison, which, simulation, interrupt);
    first.go(allowance, &sampler, run);
    const bool repeat = run.status == CaseStatus::done && first.seconds() < allowance.repeat;
    for (int k = 1; repeat && k < repeats; ++k) {
      CaseRun again;
      Pass(comparison, which, simulation, interrupt).go({1e12}, nullptr, again);
      if (again.status != CaseStatus::done) continue;
      run.work.seconds.push_back(again.work.seconds.front());
      run.work.cpu = std::min(run.work.cpu, again.work.cpu);
    }
  } catch (const sim::InputError& error) {
    run.status = CaseStatus::failed;
    run.reason = error.what();
  }
  return run;
}

CaseRun refused_case(const TradeCase& which, const std::string& reason) {
  CaseRun run;
  run.which = which;
  run.status = CaseStatus::failed;
  run.reason = reason;
  return run;
}

std::vector<sim::TimedStep> timed_steps(const Comparison& comparison, const TradeCase& which,
                                        const Simulation& simulation, double seconds, const Interrupt& interrupt) {
  return Pass(comparison, which, simulation, interrupt).go(seconds);
}

}  // namespace app
