// Exit codes of the program.
#pragma once

namespace app {

constexpr int kDone = 0;
constexpr int kBadInput = 2;
constexpr int kNumericalFailure = 3;  // reported, last good state saved
constexpr int kFramesDiffer = 4;      // from those of --expect
constexpr int kInterrupted = 130;     // what was written stays valid

}  // namespace app
