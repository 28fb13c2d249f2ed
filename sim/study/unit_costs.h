// What the parts of a step cost on this machine, found from steps that were timed.
#pragma once

#include <span>

namespace sim {

// How often something was done: in one step, or in a simulated second.
struct StepCounts {
  double steps = 1, force_evaluations = 0, factorisations = 0, linear = 0;
};

struct TimedStep {
  StepCounts counts;
  double seconds = 0;  // wall, > 0
};

// Seconds for each, none negative.
struct UnitCosts {
  double step = 0, force_evaluation = 0, factorisation = 0, linear = 0;

  UnitCosts operator*(double factor) const {
    return {factor * step, factor * force_evaluation, factor * factorisation, factor * linear};
  }
  double of(const StepCounts& counts) const {
    return step * counts.steps + force_evaluation * counts.force_evaluations + factorisation * counts.factorisations +
           linear * counts.linear;
  }
};

// The costs u >= 0 that minimise sum (u.c_i / s_i - 1)^2 over steps with counts c_i and seconds s_i, first over all of
// them, then over those that were not held up; scaled so that a quarter of the steps were faster. Other programs can
// only make a step slower, so the fast ones tell what it costs by itself. All zero without steps.
UnitCosts unit_costs(std::span<const TimedStep> steps);

// How many times longer than these costs say the steps took; a quarter of them took less. 1 without steps.
double pace(std::span<const TimedStep> steps, const UnitCosts& costs);

}  // namespace sim
