// What a picture knows of the frames before it: the largest value shown in colour, and energies over time.
#pragma once

#include <optional>
#include <vector>

#include "app/picture/moment.h"
#include "app/scene/simulation.h"

namespace app {

class FrameHistory {
 public:
  // Keeps only what the look of the simulation shows; the simulation must outlive it, or the next call of follow.
  explicit FrameHistory(const Simulation& simulation) { follow(simulation); }
  // Goes on after frames of which these energies are known.
  FrameHistory(const Simulation& simulation, std::vector<Energies> before);

  // From now on frames are of this simulation.
  void follow(const Simulation& simulation);
  // Takes the next frame in (one that is earlier than others replaces them), and its largest value into `largest`,
  // which is saved with the state.
  void add(const sim::State& state, LargestShown& largest);
  // What is known of the frames so far, put into a moment.
  void fill(const LargestShown& largest, Moment& moment) const;

 private:
  const sim::System* system_ = nullptr;
  std::optional<sim::Quantity> coloured_;  // whose range comes from the values
  bool shows_energies_ = false;
  std::vector<Energies> energies_;
};

}  // namespace app
