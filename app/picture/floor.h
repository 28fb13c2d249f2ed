// The floor that is drawn: below everything that moves and below every obstacle.
#pragma once

#include <optional>

#include "app/picture/stage.h"
#include "app/scene/document.h"
#include "render/frame.h"
#include "sim/system.h"

namespace app {

class Floor {
 public:
  // The system must outlive it. There is none in the plane, where the look does without one, over a plane obstacle that
  // is a floor itself, and under bodies that nothing holds: they would fall through it.
  Floor(const sim::System& system, const Document& document, const Stand& stand);

  // It gives way to what comes lower than the scene lets expect, but not where the look names its height.
  std::optional<render::Ground> at(const sim::State& state) const;

 private:
  const sim::System& system_;
  Stand stand_;
  bool drawn_ = false, given_ = false;
  double height_ = 0;  // m along up
  double gap_ = 0;     // m: cannot be seen, but keeps the floor from flickering through the faces that lie on it
};

}  // namespace app
