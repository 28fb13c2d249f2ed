// Long runs: what 100,000 steps of every scheme do to the momenta and the energy of a body in free flight, and to the
// place of one at rest.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/study/flight_drift.h"

namespace app {

struct Flight {
  std::string scheme;
  sim::FlightDrift flying, resting;
};

std::vector<Flight> fly(std::int64_t steps, int threads, const std::function<bool()>& interrupted);

// Header and a line a scheme, with their ends.
std::string flight_table(const std::vector<Flight>& flights, std::int64_t steps);

}  // namespace app
