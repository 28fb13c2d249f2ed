// Draws the frames of a run without a window, with the panel beside them where that is wanted.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/options/options.h"
#include "app/panel/panel.h"
#include "app/picture/picture.h"
#include "app/scene/simulation.h"
#include "render/gui.h"
#include "render/renderer.h"

namespace app {

// What is seen: a simulation, kept for as long as it is drawn, and the values that wait for its restart.
struct ShownScene {
  std::shared_ptr<const Simulation> simulation;
  Picture picture;
  std::vector<Override> waiting;
};

// What the options say of a frame, pixels.
struct FrameSize {
  explicit FrameSize(const Options& options);
  double aspect() const { return double(width - panel) / height; }  // of the picture
  int width, height, panel, samples;                                // panel: at the left; 0: none
};

// Owns its GL context: made and used in one thread.
class FrameRenderer {
 public:
  explicit FrameRenderer(const FrameSize& size);
  // samples: of the panel's plots.
  render::Image draw(const ShownScene& shown, const Moment& moment, const std::vector<Sample>& samples);

 private:
  FrameSize size_;  // in the order of their making
  std::unique_ptr<render::Context> context_ = render::make_offscreen_context();
  render::Renderer renderer_;
  std::optional<render::Gui> gui_;
  Panel panel_;
};

}  // namespace app
