#include "app/picture/frame_history.h"

#include <algorithm>

#include "app/picture/colour_values.h"
#include "app/picture/energies.h"

namespace app {
namespace {

std::optional<sim::Quantity> free_range(const Look& look) {
  return look.range ? std::nullopt : quantity(look.colour);
}

}  // namespace

FrameHistory::FrameHistory(const Simulation& simulation, std::vector<Energies> before) : FrameHistory(simulation) {
  if (shows_energies_) energies_ = std::move(before);
}

void FrameHistory::follow(const Simulation& simulation) {
  system_ = simulation.system.get();
  coloured_ = free_range(simulation.document.look);
  shows_energies_ = simulation.document.look.energies;
  if (!shows_energies_) energies_.clear();
}

void FrameHistory::add(const sim::State& state, LargestShown& largest) {
  if (coloured_) {
    double& reach = largest[static_cast<std::size_t>(*coloured_)];
    reach = std::max(reach, reach_of(*coloured_, system_->node_values(state, *coloured_)));
  }
  if (!shows_energies_) return;
  const Energies now = energies_of(*system_, state);
  std::erase_if(energies_, [&](const Energies& other) { return other.t >= now.t; });
  energies_.push_back(now);
}

void FrameHistory::fill(const LargestShown& largest, Moment& moment) const {
  if (coloured_) moment.largest = largest[static_cast<std::size_t>(*coloured_)];
  moment.energies = energies_;
}

}  // namespace app
