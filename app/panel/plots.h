// The plots of the panel: the last steps of the run.
#pragma once

#include <vector>

#include "app/session/monitor.h"

namespace app {

// Energies, iterations and the smallest J over time; with `clock` milliseconds a step by phase too. One below the other
// at the cursor of Dear ImGui, `text` pixels high letters.
void draw_plots(const std::vector<Sample>& samples, bool clock, float text);

}  // namespace app
