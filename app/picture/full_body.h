// Bodies that move in a basis, in all of their nodes: stepped beside them, from frame to frame, to be drawn as their
// ghosts.
#pragma once

#include <cstdint>
#include <memory>

#include "app/scene/simulation.h"
#include "sim/stepper.h"

namespace app {

class FullBody {
 public:
  // Of a simulation whose bodies have a basis. Throws SceneError.
  explicit FullBody(const Simulation& simulation);

  // From now on it moves as in this simulation, from where it is. Throws SceneError.
  void follow(const Simulation& simulation);
  // Goes on to a frame; to an earlier one it goes back by taking the state that the bodies in the basis have there.
  void reach(std::int64_t frame, const sim::State& in_basis);
  // Where the nodes are [m]; empty where a step could not be taken.
  const Eigen::VectorXd& x() const { return state_.x; }

 private:
  std::shared_ptr<const sim::System> system_;
  std::unique_ptr<sim::Stepper> stepper_;
  sim::State state_;
  std::int64_t frame_ = 0;
};

}  // namespace app
