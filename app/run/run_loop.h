// Takes a simulation from a state to its last frame, and leaves its numbers in a run folder.
#pragma once

#include "app/options/options.h"
#include "app/run/frame_sink.h"
#include "app/run/outcome.h"
#include "app/run/run_folder.h"
#include "app/run/run_start.h"
#include "app/scene/simulation.h"

namespace app {

// Steps until the end, an interruption (SIGINT, SIGTERM) or a numerical failure; then state.bin holds the last good
// state and run.json says how it went. Unless resumed, the files of an earlier run in the folder are removed first.
// Throws what else ends a run, a WriteError say, after run.json says so where it can.
Outcome run_loop(const Simulation& simulation, const Options& options, const RunFolder& folder, const RunStart& start,
                 FrameSink& sink);

}  // namespace app
