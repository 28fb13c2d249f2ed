// What the mouse does in the picture: it moves the camera, or takes hold of a body.
#pragma once

#include <optional>

#include "app/session/input.h"
#include "app/view/pick.h"
#include "render/window.h"

namespace app {

// What is on the screen.
struct Scenery {
  const render::Frame& frame;
  const sim::System& system;
  const sim::State& state;
  int width, height;  // pixels
};

class Mouse {
 public:
  // The input that the event makes, if any. Inputs of a move are to be applied before the next event.
  std::optional<Input> handle(const render::WindowEvent& event, const Scenery& now);
  // Lets go without a word.
  void drop() { held_.reset(), grip_.reset(); }

  // The body and the node that are pulled.
  struct Grip {
    Picked picked;
    sim::Vec3 from;  // where the ray met the plane of the pull when it began
  };
  const std::optional<Grip>& grip() const { return grip_; }

 private:
  std::optional<Input> press(const render::WindowEvent& event, const Scenery& now);
  std::optional<Input> move(const render::WindowEvent& event, const Scenery& now);
  std::optional<Input> release(const render::WindowEvent& event);

  std::optional<render::Button> held_;
  std::optional<Grip> grip_;
  float x_ = 0, y_ = 0;  // where the last event was
};

}  // namespace app
