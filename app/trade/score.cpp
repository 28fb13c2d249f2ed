#include "app/trade/score.h"

#include <algorithm>
#include <limits>

#include "sim/study/difference.h"

namespace app {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Whether it sets such a key of a body.
bool changes(const TradeCase& which, bool (*is_such)(std::string_view key)) {
  return std::ranges::any_of(which.settings, [&](const auto& setting) {
    return setting.first.starts_with("body.") && is_such(setting.first);
  });
}
bool changes_model(const TradeCase& which) {
  return changes(which, [](std::string_view key) { return key.ends_with("material.model"); });
}
// But for what they move in: all bases are measured against the reference, which has all nodes.
bool changes_bodies(const TradeCase& which) {
  return changes(which, [](std::string_view key) { return key.find(".basis.") == std::string_view::npos; });
}

// Whether scheme and step are those of the mesh study, and nothing but meshes and masses differs.
bool in_mesh_study(const TradeCase& which, const TradeCase& mesh_time) {
  std::size_t of_time = 0;
  for (const auto& setting : which.settings) {
    if (setting.first.starts_with("body.")) continue;
    if (std::ranges::find(mesh_time.settings, setting) == mesh_time.settings.end()) return false;
    ++of_time;
  }
  return of_time == mesh_time.settings.size() && !changes_model(which);
}

Apart sum(const Apart& a, const Apart& b) {
  return {a.rms + b.rms, a.max + b.max, a.pixels + b.pixels};
}

}  // namespace

double error_of(const Apart& apart, const Goal& goal) {
  return goal.kind == Goal::Kind::pixels ? apart.pixels : apart.rms;
}

void Scorer::set(const References& references) {
  references_ = references;
  known_.clear();
}

void Scorer::set(const Costs& costs) {
  costs_ = costs;
  for (auto& [run, score] : known_) score.seconds = costs_.seconds(*run);
}

Apart Scorer::apart(const CaseRun& a, const CaseRun& b) const {
  const int frames = references_.check.frames;
  const sim::Difference difference = sim::difference(a.path, b.path, comparison_.points, frames);
  const sim::Difference pixels =
      sim::difference(on_screen(comparison_, a.path), on_screen(comparison_, b.path), screen_, frames);
  return {difference.rms, difference.max, pixels.rms};
}

const Score& Scorer::score(const CaseRun& run) {
  const auto found = known_.find(&run);
  if (found != known_.end()) return found->second;
  return known_.emplace(&run, judge(run)).first->second;
}

Score Scorer::judge(const CaseRun& run) const {
  Score score;
  score.run = &run;
  score.seconds = costs_.seconds(run);
  score.bound = {infinite, infinite, infinite};
  if (run.status != CaseStatus::done || !references_.time) return score;
  judge_against_time(score);
  if (references_.mesh) judge_against_mesh(score);
  return score;
}

void Scorer::judge_against_time(Score& score) const {
  const CaseRun &run = *score.run, &reference = *references_.time;
  const int frames = references_.check.frames;
  score.centre = sim::centre_difference(run.path, reference.path, comparison_.points, frames);
  const bool same = !changes_bodies(run.which);
  if (!same && !changes_model(run.which)) return;
  const Apart error = apart(run, reference);
  (same ? score.time : score.model) = error;
  const sim::Drift drift = sim::drift(run.path, reference.path, comparison_.points);
  score.energy_drift = drift.energy;
  score.momentum_drift = drift.momentum;
  score.mean_energy = drift.mean_energy;
  const double floor = 10 * references_.check.uncertainty;
  score.resolved = error.rms >= floor;
  score.below = error.rms < told_apart * references_.check.uncertainty;
  if (!references_.mesh) score.bound = sum(error, references_.uncertainty);
}

void Scorer::judge_against_mesh(Score& score) const {
  const CaseRun& run = *score.run;
  if (&run == references_.mesh) {
    score.total = Apart{};
    score.bound = references_.total_uncertainty;
    return;
  }
  score.total = apart(run, *references_.mesh);
  if (in_mesh_study(run.which, references_.mesh_time)) score.mesh = score.total;
  Apart largest = *score.total;
  for (const auto& part : {score.time, score.model})
    if (part)
      largest = {std::max(largest.rms, part->rms), std::max(largest.max, part->max),
                 std::max(largest.pixels, part->pixels)};
  score.bound = sum(largest, references_.total_uncertainty);
}

}  // namespace app
