// What `ritz explain` says of bodies that move in a basis.
#pragma once

#include "app/options/options.h"
#include "app/scene/simulation.h"

namespace app {

// Nothing for a scene without one. Throws SceneError, std::runtime_error.
void print_bases(const Simulation& simulation, const Options& options);

}  // namespace app
