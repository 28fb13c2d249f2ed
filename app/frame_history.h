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
  // Goes on from a start that was resumed. Keeps only what the look shows.
  FrameHistory(const Simulation& simulation, const RunFolder& folder, const Start& start);

  // Takes the next frame in, and adds the largest value to the totals, which are saved with the state.
  void add(const sim::State& state, Totals& totals);
  // What is known of the frames so far, put into a moment.
  void fill(const Totals& totals, Moment& moment) const;

 private:
  const sim::System& system_;
  std::optional<sim::Quantity> coloured_;  // whose range comes from the values
  bool shows_energies_;
  std::vector<Energies> energies_;
};

}  // namespace app
