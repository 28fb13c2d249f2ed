// run.json: what was run, how it went and what it cost.
#pragma once

#include <string>

#include "app/options/options.h"
#include "app/run/frame_sink.h"
#include "app/run/outcome.h"
#include "app/run/run_folder.h"
#include "app/scene/simulation.h"

namespace app {

std::string run_json(const Simulation& simulation, const Options& options, const RunFolder& folder,
                     const Outcome& outcome, const FrameSink& frames);

}  // namespace app
