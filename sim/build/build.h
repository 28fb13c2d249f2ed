// Turns a scene into the parts of a system.
#pragma once

#include <memory>

#include "sim/build/parts.h"
#include "sim/mesh/input_error.h"
#include "sim/scene.h"

namespace sim {

// Throws InputError with the key at fault.
std::unique_ptr<Parts> build(const Scene& scene, int threads);

}  // namespace sim
