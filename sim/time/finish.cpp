#include "sim/time/finish.h"

#include <limits>

namespace sim {

bool finish_step(const System::Parts& parts, TangentOperator& tangent, const State& state, StepReport& report) {
  report.min_J = std::numeric_limits<double>::infinity();
  std::size_t k = 0;
  for (std::size_t e = 0; e < parts.elastic.size(); ++e) {
    while (parts.terms[k].get() != parts.elastic[e]) ++k;
    const ElasticTerm::SmallestJ least = parts.elastic[e]->smallest_J(state.x, *tangent.stores()[k]);
    report.inverted += least.inverted;
    if (!(least.J >= report.min_J)) {
      report.min_J = least.J;
      report.min_J_element = parts.ranges[parts.elastic_body[e]].first_element + least.element;
    }
  }
  if (!state.x.allFinite() || !state.v.allFinite())
    report.failure = "positions or velocities are not finite";
  else if (state.x.cwiseAbs().maxCoeff() > parts.bound)
    report.failure = "positions have left all bounds (1e12 sizes of the scene): the step is unstable";
  return report.failure.empty();
}

}  // namespace sim
