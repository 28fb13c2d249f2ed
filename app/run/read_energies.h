// Energies of a run's frames, read back from its steps.csv.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "app/picture/moment.h"
#include "sim/system.h"

namespace app {

// Of frame 0 and of the frames up to `last_step`, as steps.csv has them: what a resumed run goes on with.
std::vector<Energies> read_energies(const std::filesystem::path& steps_csv, const sim::System& system,
                                    std::int64_t last_step);

}  // namespace app
