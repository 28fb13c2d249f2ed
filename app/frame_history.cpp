#include "app/frame_history.h"

#include <algorithm>

#include "app/colour_values.h"
#include "app/energies.h"

namespace app {
namespace {

std::optional<sim::Quantity> free_range(const Look& look) {
  return look.range ? std::nullopt : quantity(look.colour);
}

}  // namespace

FrameHistory::FrameHistory(const Simulation& simulation, const RunFolder& folder, const Start& start)
    : FrameHistory(simulation) {
  if (shows_energies_ && start.resumed) energies_ = read_energies(folder.steps(), *system_, start.run.state.step);
}

void FrameHistory::follow(const Simulation& simulation) {
  system_ = simulation.system.get();
  coloured_ = free_range(simulation.document.look);
  shows_energies_ = simulation.document.look.energies;
  if (!shows_energies_) energies_.clear();
}

void FrameHistory::add(const sim::State& state, Totals& totals) {
  if (coloured_) {
    double& largest = totals.largest[static_cast<std::size_t>(*coloured_)];
    largest = std::max(largest, reach_of(*coloured_, system_->node_values(state, *coloured_)));
  }
  if (!shows_energies_) return;
  const Energies now = energies_of(*system_, state);
  std::erase_if(energies_, [&](const Energies& other) { return other.t >= now.t; });
  energies_.push_back(now);
}

void FrameHistory::fill(const Totals& totals, Moment& moment) const {
  if (coloured_) moment.largest = totals.largest[static_cast<std::size_t>(*coloured_)];
  moment.energies = energies_;
}

}  // namespace app
