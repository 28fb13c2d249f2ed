// The contacts of a scene: which surfaces may touch, and the rules between them where the scene gives none.
//   dh     1e-3 of the smaller body; of a body with itself also at most half of the least distance at rest of
//          primitives that share no point: no force at rest
//   kappa  sim/build/impact.h, the smaller of both
//   xi     0
#pragma once

#include "sim/build/parts.h"
#include "sim/scene.h"

namespace sim {

// Adds one term for each entry of scene.contacts. Throws InputError, where bodies start crossed or too near as well.
void add_contacts(Parts& parts, const Scene& scene);
// Adds one term for every body and obstacle k of the model, a surface; dh and kappa are those of the body.
void add_contacts_with_obstacle(Parts& parts, std::size_t k);

}  // namespace sim
