// Which schemes keep bodies off each other and off obstacles.
#pragma once

#include "sim/build/parts.h"
#include "sim/scene.h"

namespace sim {

// Whether the scheme can step the scene: it keeps barriers, or there are none, for want of contacts and obstacles.
bool serves(const Scheme& scheme, const Scene& scene);
// Throws InputError where it does not.
void check_barrier_scheme(const Parts& parts, const Scene& scene);

}  // namespace sim
