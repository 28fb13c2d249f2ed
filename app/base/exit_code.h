// Exit codes of the program.
#pragma once

namespace app {

constexpr int exit_done = 0;
constexpr int exit_bad_input = 2;
constexpr int exit_numerical_failure = 3;  // reported, last good state saved
constexpr int exit_frames_differ = 4;      // from those of --expect
constexpr int exit_interrupted = 130;      // what was written stays valid

}  // namespace app
