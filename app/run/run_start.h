// Where a run begins: its folder and its first state.
#pragma once

#include "app/options/options.h"
#include "app/run/run_folder.h"
#include "app/run/state_file.h"
#include "app/scene/simulation.h"

namespace app {

// The folder that the options name: --resume, -o, or out/NAME of the scene file. Throws as RunFolder does.
RunFolder open_run_folder(const Options& options);

struct RunStart {
  SavedRun run;
  bool resumed = false;
};

// The initial state, or the state that the folder holds. Throws std::runtime_error when that is the state of another
// scene or lies behind the scene's end.
RunStart make_start(const Simulation& simulation, const RunFolder& folder, bool resume);

}  // namespace app
