// Which schemes keep bodies off each other and off obstacles.
#pragma once

#include "sim/build/parts.h"
#include "sim/scene.h"

namespace sim {

// Throws InputError where the scene has a contact or an obstacle and its scheme cannot keep their barriers.
void check_barrier_scheme(const Parts& parts, const Scene& scene);

}  // namespace sim
