#include "app/simulation.h"

#include <cmath>

#include "app/scene_file.h"
#include "app/scene_identity.h"
#include "app/stopwatch.h"

namespace app {

std::int64_t Simulation::last_frame() const {
  const sim::Time& time = document.scene.time;
  return std::llround(time.seconds * time.fps);
}

std::vector<std::string> Simulation::remarks() const {
  std::vector<std::string> all = document.remarks;
  const std::vector<std::string> of_system = system->remarks();
  all.insert(all.end(), of_system.begin(), of_system.end());
  return all;
}

Simulation build_simulation(const Options& options) {
  const Stopwatch watch;
  Simulation simulation;
  simulation.document = load_scene(options.scene, options.settings, options.overrides);
  try {
    simulation.system = std::make_unique<sim::System>(simulation.document.scene, options.threads);
  } catch (const sim::InputError& error) {
    throw located(error, simulation.document.places);
  }
  simulation.identity = scene_identity(simulation.document);
  simulation.build_seconds = watch.seconds();
  return simulation;
}

}  // namespace app
