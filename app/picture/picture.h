// What a frame of a run shows: the state of a system, seen as the scene says.
#pragma once

#include <string>
#include <vector>

#include "app/picture/arrows.h"
#include "app/picture/camera_path.h"
#include "app/picture/moment.h"
#include "app/picture/surface.h"
#include "app/scene/document.h"
#include "render/frame.h"
#include "sim/system.h"

namespace app {

// Holds what is the same in every frame; both arguments of the constructor must outlive it.
class Picture {
 public:
  // `aspect`: width / height of the pictures.
  Picture(const sim::System& system, const Document& document, double aspect);

  render::Frame frame(const Moment& moment) const;

 private:
  void add_values(const Moment& moment, render::Frame& frame) const;
  void add_pins(const sim::State& state, render::Frame& frame) const;
  void add_labels(render::Frame& frame) const;
  void lay_sheet(const render::Sheet& sheet, render::Frame& frame) const;

  const sim::System& system_;
  const Document& document_;
  double aspect_;
  std::vector<Surface> surfaces_;  // body by body
  render::Frame still_;            // a frame that lacks what changes
  CameraPath camera_path_;
  Arrows arrows_;
  double expected_reach_ = 0;  // of the values that colour bodies
};

}  // namespace app
