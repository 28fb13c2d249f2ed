#include "app/picture/energies.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {
namespace {

// A prefix for the unit, by the largest number.
std::pair<const char*, double> unit_for(double largest) {
  if (largest >= 1e6) return {"MJ", 1e-6};
  if (largest >= 1e3) return {"kJ", 1e-3};
  if (largest >= 1 || largest == 0) return {"J", 1};
  if (largest >= 1e-3) return {"mJ", 1e3};
  return {"\u00b5J", 1e6};
}

}  // namespace

Energies energies_of(const sim::System& system, const sim::State& state) {
  const sim::Measures now = system.measure(state);
  return {system.time(state.step), now.kinetic, now.elastic, now.potential};
}

render::Strip energy_strip(const std::vector<Energies>& energies, double until) {
  double largest = 0;
  for (const Energies& e : energies) {
    largest = std::max({largest, e.kinetic, e.elastic, std::abs(e.potential)});
  }
  const auto [unit, factor] = unit_for(largest);
  render::Strip strip;
  strip.title = "energy";
  strip.unit = unit;
  strip.until = static_cast<float>(until);
  strip.series = {{"kinetic", {}}, {"elastic", {}}, {"potential", {}}, {"total", {}}};
  for (const Energies& e : energies) {
    strip.times.push_back(static_cast<float>(e.t));
    const double values[] = {e.kinetic, e.elastic, e.potential, e.kinetic + e.elastic + e.potential};
    for (std::size_t i = 0; i < 4; ++i) strip.series[i].values.push_back(static_cast<float>(factor * values[i]));
  }
  return strip;
}

}  // namespace app
