// `ritz record --replay`: a session of `ritz view`, drawn again without a window.
#pragma once

#include "app/options/options.h"

namespace app {

// Does what the session did, between the same steps, and draws every frame that it passed, numbered as they come.
// Leaves frames, run.json, state.bin and a copy of the session in the run folder. Returns the exit code; throws as
// record does.
int replay(const Options& options);

}  // namespace app
