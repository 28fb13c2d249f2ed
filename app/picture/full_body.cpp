#include "app/picture/full_body.h"

#include <utility>

namespace app {
namespace {

std::shared_ptr<const sim::System> in_all_nodes(const Simulation& simulation) {
  Document document = simulation.document;
  for (sim::Body& body : document.scene.bodies) body.basis.reset();
  return build_system(document, 1);
}

// Positions and velocities alone, at a step of another system.
sim::State moved_to(std::int64_t step, Eigen::VectorXd x, Eigen::VectorXd v) {
  sim::State state;
  state.step = step;
  state.x = std::move(x);
  state.v = std::move(v);
  return state;
}

}  // namespace

FullBody::FullBody(const Simulation& simulation) {
  follow(simulation);
  state_ = system_->initial_state();
}

void FullBody::follow(const Simulation& simulation) {
  system_ = in_all_nodes(simulation);
  stepper_ = sim::make_stepper(*system_, 1);
  state_ = moved_to(frame_ * system_->steps_per_frame(), std::move(state_.x), std::move(state_.v));
}

void FullBody::reach(std::int64_t frame, const sim::State& in_basis) {
  const std::int64_t step = frame * system_->steps_per_frame();
  if (frame == 0) state_ = system_->initial_state();
  if (frame < frame_ && frame > 0) state_ = moved_to(step, in_basis.x, in_basis.v);
  frame_ = frame;
  while (state_.x.size() > 0 && state_.step < step)
    if (!stepper_->step(state_).failure.empty()) state_.x.resize(0);
}

}  // namespace app
