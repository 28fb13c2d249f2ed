// The last steps of a run in numbers, for plots.
#pragma once

#include <cstddef>
#include <vector>

#include "app/run/contact_totals.h"
#include "sim/report.h"
#include "sim/system.h"

namespace app {

struct Sample {
  double t = 0;                                    // s, of the session
  double kinetic = 0, elastic = 0, potential = 0;  // J
  int newton = 0, linear = 0;                      // iterations
  double min_J = 1;
  ContactTotals contacts = {};
  double assembling = 0, solving = 0, other = 0;  // s of wall time: for the eye only
};

// `t` [s]: the time of the session, which no reset turns back.
Sample sample_of(double t, const sim::System& system, const sim::State& state, const sim::StepReport& report);

// The latest samples, oldest first; as many as a plot has room for.
class Monitor {
 public:
  static constexpr std::size_t most = 600;

  void add(const Sample& sample);
  void clear() { samples_.clear(); }
  const std::vector<Sample>& samples() const { return samples_; }

 private:
  std::vector<Sample> samples_;
};

}  // namespace app
