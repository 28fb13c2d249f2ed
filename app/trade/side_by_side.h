// `ritz trade --show`: runs beside each other as pictures, and below each how far it is from the one at the left.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/base/interrupt.h"
#include "app/trade/advice_text.h"

namespace app {

// A run that is shown. All are drawn at the nodes of the scene's mesh, which is where errors are measured.
struct Shown {
  std::string name;     // "reference"
  std::string caption;  // "0.52 %, 2.1 px, 0.31 s"
  const CaseRun* run = nullptr;
};

// Reference, scene as it is, advice, and the cases that are named; why one of these is not drawn is noted. Throws
// std::runtime_error where there is no reference.
std::vector<Shown> choose_shown(Measurement& measurement, const Advice& advice);

// Pixels at 1080p from the first run, of every node in every compared frame: one vector a frame.
std::vector<Eigen::VectorXd> pixels_apart(const Comparison& comparison, const CaseRun& run, const CaseRun& reference);

// Of so many compared frames (0: the first) the one in which a node of any run is farthest from the first run.
int frame_apart_most(const Comparison& comparison, const std::vector<Shown>& shown, int frames);

// Draws frames into `folder`, the first run at the left, all with its camera; with options.still the one frame in which
// they differ most, of those in which errors are counted, `frames` of them; with options.video a video. Each picture is
// half as wide and high as options.width and height say. Throws WriteError, Interrupted, std::runtime_error.
void draw_side_by_side(const Comparison& comparison, const std::vector<Shown>& shown, const Options& options,
                       const std::filesystem::path& folder, int frames, const Interrupt& interrupt);

}  // namespace app
