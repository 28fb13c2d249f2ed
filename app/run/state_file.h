// state.bin: what a run goes on from.
//
// Little-endian: "RITZSTAT", version (u32), scene (u64), newton, linear, not_converged, splits (i64), min_J, largest
// (f64, 4 of them), every field of the state in the order of sim::for_each_field (integers i64, numbers f64, vectors
// their length as u64 and their numbers), FNV-1a of all before it (u64).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "app/picture/moment.h"
#include "sim/state.h"

namespace app {

// What a run has added up over its steps.
struct Totals {
  std::int64_t newton = 0;         // Newton iterations
  std::int64_t linear = 0;         // iterations of the linear solver
  std::int64_t not_converged = 0;  // steps whose equations were not solved to the tolerance
  std::int64_t splits = 0;         // times that a step, or a part of it, was repeated in halves
  double min_J = 1;                // smallest det F on the way
  LargestShown largest{};
};

struct SavedRun {
  std::uint64_t scene = 0;  // identity of what is simulated: a state goes on only in its own scene
  Totals totals;
  sim::State state;
};

std::string encode(const SavedRun& run);

// Throws std::runtime_error, beginning with `name`, when the bytes are not a whole state file: cut short, changed,
// of another version, or with numbers that no run leaves.
SavedRun decode(std::string_view bytes, const std::string& name);

// Leaves the old or the new file, whole, whenever the process ends. Throws WriteError.
void write_state_file(const std::filesystem::path& path, const SavedRun& run);

// Throws as decode does, and when the file cannot be read.
SavedRun read_state_file(const std::filesystem::path& path);

}  // namespace app
