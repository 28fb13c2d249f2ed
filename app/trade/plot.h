// The work-precision diagram, made by gnuplot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/trade/score.h"

namespace app {

struct Diagram {
  std::string name;  // of the scene, or of its settings
  std::vector<const Score*> scores;
  double uncertainty = 0;  // nothing is drawn below it
};

// The script, with the data in it: error over wall time per simulated second, both logarithmic, a line for each
// integrator, the front as a band, failures at the margin. `base`: path of the pictures without .svg and .png.
std::string plot_script(const std::vector<Diagram>& diagrams, const std::filesystem::path& base);

// Runs gnuplot on the script; false where there is none, or where it fails.
bool run_gnuplot(const std::filesystem::path& script);

}  // namespace app
