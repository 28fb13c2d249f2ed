// What many steps do to what should stay as it is.
#pragma once

#include <functional>

#include "sim/system.h"

namespace sim {

// Of a body without loads, after its flight: changes relative to the start.
struct FlightDrift {
  std::int64_t steps = 0;  // taken
  double p = 0;            // |p - p_0| / |p_0|
  double L = 0;            // |L - L_0| / |L_0|
  double energy = 0;       // (E - E_0) / E_0, kinetic and elastic
  double away = 0;         // largest |x - x_0|/size: what a body at rest should not show
  std::string failure;     // empty, or why it ended early
};

FlightDrift flight_drift(const System& system, std::int64_t steps, const std::function<bool()>& interrupted);

}  // namespace sim
