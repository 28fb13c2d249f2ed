// A scene made ready to be stepped.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/options/options.h"
#include "app/scene/document.h"
#include "sim/stepper.h"
#include "sim/system.h"

namespace app {

struct Simulation {
  Document document;
  std::shared_ptr<const sim::System> system;  // shared by simulations that differ in their looks only
  std::uint64_t identity = 0;                 // of the scene
  double build_seconds = 0;
  double basis_seconds = 0;  // that the vectors of its bases took when they were made

  std::int64_t last_frame() const;  // frames are 0, 1, ..., last_frame
  // What the user should know before the first step.
  std::vector<std::string> remarks() const;
  std::int64_t last_step() const { return last_frame() * system->steps_per_frame(); }
};

// Reads the scene that the options name and builds its system; bases of `before` serve where the bodies are the same.
// Throws SceneError.
Simulation build_simulation(const Options& options, const Simulation* before = nullptr);

// Gives the bodies of its document the vectors of their bases, where they have some: those of `before` where they
// follow from the same, those in the cache (empty: none), or new ones. Throws SceneError.
void make_bases(Simulation& simulation, const Simulation* before, const std::filesystem::path& cache, int threads);

// Throws SceneError where a scene has no body: it is a page of exhibits alone, and there is nothing to measure.
void require_bodies(const Document& document);

// The system of a document. Throws SceneError.
std::shared_ptr<const sim::System> build_system(const Document& document, int threads);

}  // namespace app
