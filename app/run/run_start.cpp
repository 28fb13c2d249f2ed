#include "app/run/run_start.h"

#include <stdexcept>

namespace app {

RunFolder open_run_folder(const Options& options) {
  if (!options.resume.empty()) return RunFolder(options.resume, Existing::resume);
  const std::filesystem::path folder =
      options.out.empty() ? std::filesystem::path("out") / options.scene.stem() : options.out;
  return RunFolder(folder, options.overwrite ? Existing::overwrite : Existing::refuse);
}

RunStart make_start(const Simulation& simulation, const RunFolder& folder, bool resume) {
  RunStart start{{simulation.identity, {}, simulation.system->initial_state()}, resume};
  if (!resume) return start;
  const std::string file = folder.state().string();
  SavedRun saved = read_state_file(folder.state());
  if (saved.scene != simulation.identity || saved.state.x.size() != start.run.state.x.size() ||
      saved.state.coordinates.c.size() != start.run.state.coordinates.c.size()) {
    throw std::runtime_error(file +
                             ": is the state of another scene (mesh, material, forces, time step or solver "
                             "differ); resume with the scene and the settings it was recorded with");
  }
  if (saved.state.step > simulation.last_step()) {
    throw std::runtime_error(file + ": was saved after step " + std::to_string(saved.state.step) +
                             ", the scene ends with step " + std::to_string(simulation.last_step()) +
                             "; give more --seconds");
  }
  start.run = std::move(saved);
  return start;
}

}  // namespace app
