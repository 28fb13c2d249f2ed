// Energies over time, drawn as a strip.
#pragma once

#include <vector>

#include "app/picture/moment.h"
#include "render/frame.h"
#include "sim/system.h"

namespace app {

Energies energies_of(const sim::System& system, const sim::State& state);

// Kinetic, elastic, potential and total energy; `until`: end of the time axis [s].
render::Strip energy_strip(const std::vector<Energies>& energies, double until);

}  // namespace app
