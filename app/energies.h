// Energies over time: read back from a run, and drawn as a strip.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "app/frame_sink.h"
#include "render/frame.h"
#include "sim/system.h"

namespace app {

Energies energies_of(const sim::System& system, const sim::State& state);

// Of frame 0 and of the frames up to `last_step`, as steps.csv has them: what a resumed run goes on with.
std::vector<Energies> read_energies(const std::filesystem::path& steps_csv, const sim::System& system,
                                    std::int64_t last_step);

// Kinetic, elastic, potential and total energy; `until`: end of the time axis [s].
render::Strip energy_strip(const std::vector<Energies>& energies, double until);

}  // namespace app
