// The commands of the program. Each returns its exit code; bad input throws SceneError, sim::InputError or
// std::runtime_error, which main reports.
#pragma once

#include "app/options.h"

namespace app {

// Exit codes of the program.
constexpr int kDone = 0;
constexpr int kBadInput = 2;
constexpr int kNumericalFailure = 3;  // reported, last good state saved
constexpr int kFramesDiffer = 4;      // from those of --expect
constexpr int kInterrupted = 130;     // what was written stays valid

int record(const Options& options);   // step and draw
int run(const Options& options);      // step only: the numbers
int view(const Options& options);     // the window
int explain(const Options& options);  // what is modelled and what it costs, before a step is taken

}  // namespace app
