// What a frame of a run shows: the state of a system, seen as the scene says.
#pragma once

#include <string>
#include <vector>

#include "app/picture/arrows.h"
#include "app/picture/camera_path.h"
#include "app/picture/floor.h"
#include "app/picture/moment.h"
#include "app/picture/surface.h"
#include "app/scene/document.h"
#include "render/frame.h"
#include "render/room.h"
#include "sim/system.h"

namespace app {

// Holds what is the same in every frame; both arguments of the constructor must outlive it.
class Picture {
 public:
  // Width and height of the pictures: pixels.
  Picture(const sim::System& system, const Document& document, int width, int height);

  render::Frame frame(const Moment& moment) const;
  // m, what positions in the frames are relative to.
  const Vec3& origin() const { return stand_.origin; }

 private:
  void add_values(const Moment& moment, render::Frame& frame) const;
  void add_pins(const sim::State& state, render::Frame& frame) const;
  void place_obstacles(const sim::State& state, render::Frame& frame) const;
  bool shows_labels() const;
  bool is_placed() const;
  void lay_sheet(const render::Sheet& sheet, render::Frame& frame) const;

  const sim::System& system_;
  const Document& document_;
  Stand stand_;
  double aspect_;
  std::vector<Surface> surfaces_;         // body by body
  std::vector<std::size_t> of_obstacle_;  // which obstacle each surface behind those of bodies is of
  render::Frame still_;                   // a frame that lacks what changes
  CameraPath camera_path_;
  Floor floor_;
  Arrows arrows_;
  bool shows_energies_ = false;
  render::Box room_;           // of the bodies in the picture
  double expected_reach_ = 0;  // of the values that colour bodies
};

}  // namespace app
