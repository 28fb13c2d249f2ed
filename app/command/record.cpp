#include "app/command/commands.h"
#include "app/record/recorder.h"
#include "app/record/replay.h"
#include "app/run/run_loop.h"
#include "app/run/run_start.h"

namespace app {

int record(const Options& options) {
  if (!options.replay.empty()) return replay(options);
  const auto simulation = std::make_shared<const Simulation>(build_simulation(options));
  const RunFolder folder = open_run_folder(options);
  const RunStart start = make_start(*simulation, folder, !options.resume.empty());
  Recorder recorder(simulation, folder, options);
  const Outcome outcome = run_loop(*simulation, options, folder, start, recorder);
  return judged(conclude(*simulation, options, folder, outcome), recorder, folder, options);
}

}  // namespace app
