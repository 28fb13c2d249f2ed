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
  double uncertainty = 0;          // of the reference: no time error is drawn below it
  double total_uncertainty = 0;    // no total error is drawn below it
  const Score* advised = nullptr;  // marked
};

// The script, with the data in it. Logarithmic, over wall time per simulated second: the time error on the scene's mesh
// and, where it is known, the total error; a line for each integrator, the front as a band, failures at the upper
// margin. Of several diagrams the fronts alone. `base`: path of the pictures without .svg and .png.
std::string plot_script(const std::vector<Diagram>& diagrams, const std::filesystem::path& base);

}  // namespace app
