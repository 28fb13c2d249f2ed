#include "sim/time/finish.h"

#include <limits>

namespace sim {

void measure_J(const Model& model, TangentOperator& tangent, const State& state, StepReport& report) {
  report.min_J = std::numeric_limits<double>::infinity();
  for (const ElasticPart& part : model.elastic) {
    const ElasticTerm::SmallestJ least = part.term->smallest_J(state.x, *tangent.stores()[part.number]);
    report.inverted += least.inverted;
    if (!(least.J >= report.min_J)) {
      report.min_J = least.J;
      report.min_J_element = model.ranges[part.body].first_element + least.element;
    }
  }
}

bool finish_step(const Model& model, TangentOperator& tangent, const State& state, StepReport& report) {
  measure_J(model, tangent, state, report);
  if (!state.x.allFinite() || !state.v.allFinite())
    report.failure = "positions or velocities are not finite";
  else if (state.x.lpNorm<Eigen::Infinity>() > model.bound)
    report.failure = "positions have left all bounds (1e12 sizes of the scene): the step is unstable";
  return report.failure.empty();
}

}  // namespace sim
