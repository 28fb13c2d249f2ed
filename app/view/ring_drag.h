// The ring of an exhibit that the mouse holds.
#pragma once

#include <optional>

#include "app/picture/frame_history.h"
#include "app/session/input.h"
#include "render/window.h"

namespace app {

class RingDrag {
 public:
  struct Answer {
    bool taken = false;            // the event was for a ring: nothing else is to act on it
    std::optional<SetKey> change;  // what moving the ring sets
  };
  // Takes hold of the ring under the mouse, moves it, or lets it go, in a picture of this size in pixels.
  Answer handle(const render::WindowEvent& event, const FrameHistory& frames, const sim::State& state, int width,
                int height);

 private:
  std::optional<std::size_t> ring_;  // its number among those of the picture
};

}  // namespace app
