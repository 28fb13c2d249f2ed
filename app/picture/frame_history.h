// What a picture knows of the frames before it: the largest value shown in colour, energies over time, and what the
// exhibits have kept.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/exhibit/exhibit.h"
#include "app/picture/full_body.h"
#include "app/picture/moment.h"
#include "app/scene/simulation.h"

namespace app {

// A ring of an exhibit, the key of the scene that it sets, and the diagram that it is in.
struct Ring {
  std::string key;
  Grip grip;
  render::Diagram diagram;
};

class FrameHistory {
 public:
  // Keeps only what the look of the simulation shows; the simulation must outlive it, or the next call of follow.
  explicit FrameHistory(const Simulation& simulation) { follow(simulation); }
  // Goes on after frames of which these energies are known.
  FrameHistory(const Simulation& simulation, std::vector<Energies> before);

  // From now on frames are of this simulation. Throws SceneError where an exhibit has not what it shows.
  // made: exhibits that are taken where they are those of the simulation.
  void follow(const Simulation& simulation, Exhibits made = {});
  // After an input of a session: the simulation may be another, the state an earlier one. Frames later than it are
  // forgotten; where it is at one, that is taken in anew.
  void revise(const Simulation& simulation, const sim::State& state, LargestShown& largest, Exhibits made = {});
  // Takes the next frame in (one that is earlier than others replaces them), and its largest value into `largest`,
  // which is saved with the state.
  void add(const sim::State& state, LargestShown& largest);
  // What is known of the frames so far, put into a moment, with what the exhibits show of its state.
  void fill(const LargestShown& largest, Moment& moment) const;
  // What the exhibits keep for their curves, to be written and to be restored.
  std::vector<Trace*> traces() const;
  // What can be dragged in a picture of this state.
  std::vector<Ring> rings(const sim::State& state) const;

 private:
  void follow_exhibits(const Simulation& simulation, Exhibits made);
  void follow_full_body(const Simulation& simulation);

  const sim::System* system_ = nullptr;
  std::optional<sim::Quantity> coloured_;  // whose range comes from the values
  bool shows_energies_ = false;
  Exhibits exhibits_;
  std::vector<Energies> energies_;
  std::optional<FullBody> full_;  // whose ghosts are seen
};

}  // namespace app
