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
    : system_(*simulation.system),
      coloured_(free_range(simulation.document.look)),
      shows_energies_(simulation.document.look.energies) {
  if (shows_energies_ && start.resumed) energies_ = read_energies(folder.steps(), system_, start.run.state.step);
}

void FrameHistory::add(const sim::State& state, Totals& totals) {
  if (coloured_) {
    double& largest = totals.largest[static_cast<std::size_t>(*coloured_)];
    largest = std::max(largest, reach_of(*coloured_, system_.node_values(state, *coloured_)));
  }
  if (shows_energies_) energies_.push_back(energies_of(system_, state));
}

void FrameHistory::fill(const Totals& totals, Moment& moment) const {
  if (coloured_) moment.largest = totals.largest[static_cast<std::size_t>(*coloured_)];
  moment.energies = energies_;
}

}  // namespace app
