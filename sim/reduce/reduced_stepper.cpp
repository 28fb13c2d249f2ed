#include "sim/reduce/reduced_stepper.h"

#include <limits>
#include <utility>

#include "sim/solve/stopwatch.h"
#include "sim/time/explicit.h"
#include "sim/time/implicit.h"

namespace sim {

namespace {

// The coordinates as the state of a system, and back; what one of them holds moves to the other.
void exchange(State& inner, State& state) {
  Coordinates& q = state.coordinates;
  inner.x.swap(q.c);
  inner.v.swap(q.rate);
  inner.x_before.swap(q.c_before);
  inner.v_before.swap(q.rate_before);
  inner.force.swap(q.force);
  inner.fastest.swap(state.fastest);
}

}  // namespace

ReducedStepper::ReducedStepper(const Model& full, const Reduction& reduction, const Scheme& scheme, int threads)
    : full_(full), reduction_(reduction) {
  if (scheme.is_explicit())
    stepper_ = std::make_unique<ExplicitStepper>(reduction.model, scheme, threads);
  else
    stepper_ = std::make_unique<ImplicitStepper>(reduction.model, scheme, threads);
  if (reduction.sample) {
    for (const auto& term : reduction.sample->elastic) stores_.push_back(term->make_store(threads));
    x_.resize(reduction.sample->lift->dofs());
  } else {
    for (const ElasticPart& part : full.elastic) stores_.push_back(part.term->make_store(threads));
  }
}

void ReducedStepper::note_J(const ElasticTerm& term, int body, const Eigen::VectorXd& x, Term::Store& store,
                            StepReport& report) {
  const ElasticTerm::SmallestJ least = term.smallest_J(x, store);
  report.inverted += least.inverted;
  if (least.J >= report.min_J) return;
  const auto at = static_cast<std::size_t>(body);
  const int element =
      reduction_.sample ? reduction_.sample->from[at][static_cast<std::size_t>(least.element)] : least.element;
  report.min_J = least.J;
  report.min_J_element = full_.ranges[at].first_element + element;
}

// With a cubature only the elements that are summed are looked at.
void ReducedStepper::measure_J(const State& state, StepReport& report) {
  report.min_J = std::numeric_limits<double>::infinity();
  if (!reduction_.sample) {
    for (std::size_t k = 0; k < stores_.size(); ++k)
      note_J(*full_.elastic[k].term, full_.elastic[k].body, state.x, *stores_[k], report);
    return;
  }
  const Sample& sample = *reduction_.sample;
  sample.lift->place(state.coordinates.c, x_);
  for (std::size_t k = 0; k < stores_.size(); ++k) note_J(*sample.elastic[k], sample.body[k], x_, *stores_[k], report);
}

StepReport ReducedStepper::step(State& state) {
  double seconds = 0;
  StepReport report;
  {
    const Stopwatch watch(seconds);
    if (state.coordinates.c.size() != reduction_.lift->coordinates()) reduction_.enter(state);
    inner_.step = state.step;
    inner_.parts = state.parts;
    inner_.energy_most = state.energy_most;
    inner_.kinetic_most = state.kinetic_most;
    exchange(inner_, state);
    report = stepper_->step(inner_);
    exchange(inner_, state);
    if (report.failure.empty()) {
      state.step = inner_.step;
      state.parts = inner_.parts;
      state.energy_most = inner_.energy_most;
      state.kinetic_most = inner_.kinetic_most;
      state.x_before.swap(state.x);
      state.v_before.swap(state.v);
      reduction_.lift->place(state.coordinates.c, state.x);
      reduction_.lift->move(state.coordinates.rate, state.v);
    }
    measure_J(state, report);
  }
  report.seconds = seconds;
  return report;
}

}  // namespace sim
