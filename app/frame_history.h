// What a picture knows of the frames before it: the largest value shown in colour, and energies over time.
#pragma once

#include <optional>
#include <vector>

#include "app/frame_sink.h"
#include "app/run_folder.h"
#include "app/run_start.h"
#include "app/simulation.h"

namespace app {

class FrameHistory {
 public:
  // Keeps only what the look of the simulation shows; the simulation must outlive it, or the next call of follow.
  explicit FrameHistory(const Simulation& simulation) { follow(simulation); }
  // Goes on from a start that was resumed.
  FrameHistory(const Simulation& simulation, const RunFolder& folder, const Start& start);

  // From now on frames are of this simulation.
  void follow(const Simulation& simulation);
  // Takes the next frame in (one that is earlier than others replaces them), and adds the largest value to the totals,
  // which are saved with the state.
  void add(const sim::State& state, Totals& totals);
  // What is known of the frames so far, put into a moment.
  void fill(const Totals& totals, Moment& moment) const;

 private:
  const sim::System* system_ = nullptr;
  std::optional<sim::Quantity> coloured_;  // whose range comes from the values
  bool shows_energies_ = false;
  std::vector<Energies> energies_;
};

}  // namespace app
