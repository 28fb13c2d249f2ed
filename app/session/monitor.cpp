#include "app/session/monitor.h"

#include <algorithm>

namespace app {

Sample sample_of(double t, const sim::System& system, const sim::State& state, const sim::StepReport& report) {
  const sim::Measures now = system.measure(state);
  const double other = std::max(0.0, report.seconds - report.seconds_assemble - report.seconds_solve);
  return {t,
          now.kinetic,
          now.elastic,
          now.potential,
          report.newton,
          report.linear,
          report.min_J,
          totals_of(system.contacts(state)),
          report.seconds_assemble,
          report.seconds_solve,
          other};
}

void Monitor::add(const Sample& sample) {
  if (samples_.size() == most) samples_.erase(samples_.begin());
  samples_.push_back(sample);
}

}  // namespace app
