// How deep a trade goes: chosen once from a first look at the cost, then kept in the folder so that it can be resumed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "app/trade/notebook.h"

namespace app {

struct Plan {
  int depth = 4;            // steps per frame at the fine end of the ladder
  std::int64_t frames = 0;  // of the scene that are compared
};

// The deepest plan that fits into so many seconds; only when not even the shallowest does, fewer frames: errors grow
// with time, so what is measured over a part says little of the whole. Given what one step a frame takes over the whole
// scene.
Plan affordable_plan(double seconds, double step_seconds, std::int64_t frames);

// The plan of an earlier trade of the same scene in the same time.
std::optional<Plan> read_plan(const std::filesystem::path& file, std::uint64_t scene, double seconds);
void write_plan(const std::filesystem::path& file, std::uint64_t scene, double seconds, const Plan& plan);

}  // namespace app
