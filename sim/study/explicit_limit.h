// The step limit that a scene would have in an explicit scheme.
#pragma once

#include "sim/system.h"

namespace sim {

// Largest stable h at rest [s], of the masses that the scene names. A system that is static has consistent mass
// whatever the scene says, for the sake of its weight; it is built anew with the scene's own.
double explicit_limit(const Scene& scene, const System& system, int threads);

}  // namespace sim
