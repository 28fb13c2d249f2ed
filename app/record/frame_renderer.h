// Draws the frames of a run without a window, with the panel beside them where that is wanted.
#pragma once

#include <memory>
#include <optional>
#include <string>
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
  int picture() const { return width - panel; }  // its width
  int width, height, panel, samples;             // panel: at the left; 0: none
};

// Owns its GL context: made and used in one thread.
class FrameRenderer {
 public:
  // context: the name of a kind in render/context.h; empty: the default one.
  FrameRenderer(const FrameSize& size, const std::string& context);
  // samples: of the panel's plots.
  render::Image draw(const ShownScene& shown, const Moment& moment, const std::vector<Sample>& samples);
  // What draws here, in the words of its driver.
  std::string driver() const { return render::driver_of(*context_); }

 private:
  FrameSize size_;  // in the order of their making
  std::unique_ptr<render::Context> context_;
  render::Renderer renderer_;
  std::optional<render::Gui> gui_;
  Panel panel_;
};

}  // namespace app
