// run.json: what was run, how it went and what it cost.
#pragma once

#include <string>

#include "app/frame_sink.h"
#include "app/options.h"
#include "app/outcome.h"
#include "app/run_folder.h"
#include "app/simulation.h"

namespace app {

std::string run_json(const Simulation& simulation, const Options& options, const RunFolder& folder,
                     const Outcome& outcome, const FrameSeconds& frames);

}  // namespace app
