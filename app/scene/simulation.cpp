#include "app/scene/simulation.h"

#include <cmath>

#include "app/base/stopwatch.h"
#include "app/scene/basis_cache.h"
#include "app/scene/crossed_start.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_identity.h"
#include "sim/contact/start_error.h"
#include "sim/mesh/input_error.h"
#include "sim/study/basis.h"
#include "sim/study/modes.h"

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

void require_bodies(const Document& document) {
  if (!document.scene.bodies.empty()) return;
  const sim::InputError none("body", "there is no body, and this command is about bodies");
  throw SceneError(located(none, document.places).message);
}

std::shared_ptr<const sim::System> build_system(const Document& document, int threads) {
  try {
    if (!sim::starts_in_a_mode(document.scene)) return std::make_shared<const sim::System>(document.scene, threads);
    return std::make_shared<const sim::System>(sim::with_modes_started(document.scene), threads);
  } catch (const sim::StartError& error) {
    throw CrossedStart(located(error, document.places).message, error.places);
  } catch (const sim::InputError& error) {
    throw SceneError(located(error, document.places).message);
  }
}

void make_bases(Simulation& simulation, const Simulation* before, const std::filesystem::path& cache, int threads) {
  Document& document = simulation.document;
  if (!sim::has_basis(document.scene)) return;
  if (before != nullptr && basis_identity(document) == basis_identity(before->document)) {
    std::vector<sim::Body>& bodies = document.scene.bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b)
      bodies[b].basis->vectors = before->document.scene.bodies[b].basis->vectors;
    simulation.basis_seconds = before->basis_seconds;
    return;
  }
  if (const std::optional<double> seconds = take_bases(cache, document)) {
    simulation.basis_seconds = *seconds;
    return;
  }
  const Stopwatch watch;
  try {
    document.scene = sim::with_bases_made(std::move(document.scene), threads);
  } catch (const sim::InputError& error) {
    throw SceneError(located(error, document.places).message);
  }
  simulation.basis_seconds = watch.seconds();
  keep_bases(cache, document, simulation.basis_seconds);
}

Simulation build_simulation(const Options& options, const Simulation* before) {
  const Stopwatch watch;
  Simulation simulation;
  simulation.document = load_scene(options.scene, options.settings, options.overrides);
  make_bases(simulation, before, options.cache, options.threads);
  simulation.system = build_system(simulation.document, options.threads);
  simulation.identity = scene_identity(simulation.document);
  simulation.build_seconds = watch.seconds();
  return simulation;
}

}  // namespace app
