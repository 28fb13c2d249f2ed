#include "app/record/cores.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "sim/time/scheme.h"

namespace app {
namespace {

// Seconds of one thread, estimated from recordings of the bear (run.json tells them): only their ratio matters.
constexpr double implicit_step = 7e-6;  // for a free degree of freedom
constexpr double explicit_step = 2e-7;
constexpr double pixel = 5e-8;  // drawn and written

}  // namespace

Cores share_cores(const Simulation& simulation, const Options& options) {
  const sim::System& system = *simulation.system;
  const bool is_explicit = sim::find_scheme(simulation.document.scene.time.integrator)->is_explicit();
  // Between two drawn frames.
  const double frames = options.still ? static_cast<double>(simulation.last_frame()) : options.every;
  const double steps =
      (is_explicit ? explicit_step : implicit_step) * system.counts().free_dofs * system.steps_per_frame() * frames;
  const double picture = pixel * options.width * options.height;
  const int stepping = static_cast<int>(std::lround(options.threads * steps / (steps + picture)));
  return {std::max(stepping, 1), options.threads - stepping};
}

void give_to_rasteriser(int cores) {
  // One thread beside the one that draws would only be waited for.
  setenv("LP_NUM_THREADS", std::to_string(cores >= 2 ? cores : 0).c_str(), 0);
}

}  // namespace app
