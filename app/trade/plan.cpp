#include "app/trade/plan.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>

#include "app/base/output_file.h"
#include "app/base/text.h"
#include "app/base/version.h"
#include "app/scene/value_text.h"

namespace app {
namespace {

// Steps a frame of all runs on the scene's mesh together, with depth 1: the reference 8, 4, 4 and 2, every scheme once,
// half as much for the steps that are tried then, and a little for motion that is slow at first.
constexpr double whole = 36;
constexpr int deepest_allowed = 8;
constexpr std::int64_t fewest_frames = 12;

}  // namespace

Plan affordable_plan(double seconds, double step_seconds, std::int64_t frames) {
  const double at_depth_1 = whole * step_seconds;
  Plan plan{deepest_allowed, frames};
  while (plan.depth > 1 && at_depth_1 * plan.depth > seconds) plan.depth /= 2;
  const double share = seconds / (at_depth_1 * plan.depth);
  if (share >= 1) return plan;
  plan.frames = std::clamp(static_cast<std::int64_t>(share * double(frames)), std::min(fewest_frames, frames), frames);
  return plan;
}

std::optional<Plan> read_plan(const std::filesystem::path& file, std::uint64_t scene, double seconds) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  try {
    const toml::table table = toml::parse_file(file.string());
    const bool same = table["version"].value_or(std::string()) == ritz_version &&
                      table["scene"].value_or(std::string()) == std::to_string(scene) &&
                      table["seconds"].value_or(0.0) == seconds;
    if (!same) return std::nullopt;
    return Plan{table["depth"].value_or(1), table["frames"].value_or(std::int64_t{1})};
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
}

void write_plan(const std::filesystem::path& file, std::uint64_t scene, double seconds, const Plan& plan) {
  const std::string text = "version = " + quoted_text(ritz_version) +
                           "\nscene = " + quoted_text(std::to_string(scene)) +
                           "\nseconds = " + number_literal(seconds) + "\ndepth = " + std::to_string(plan.depth) +
                           "\nframes = " + std::to_string(plan.frames) + "\n";
  write_atomically(file, text, true);
}

}  // namespace app
