// What every stepper does at the end of a step: nothing that is not finite leaves it.
#pragma once

#include "sim/report.h"
#include "sim/solve/tangent_operator.h"
#include "sim/state.h"

namespace sim {

// Smallest J and where it is, inverted elements.
void measure_J(const Model& model, TangentOperator& tangent, const State& state, StepReport& report);

// The same; false, with report.failure, when a number of the state is not finite.
bool finish_step(const Model& model, TangentOperator& tangent, const State& state, StepReport& report);

}  // namespace sim
