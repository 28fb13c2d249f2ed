// Turns a scene into the parts of a system.
#pragma once

#include <memory>

#include "sim/parts.h"

namespace sim {

// Throws InputError with the key at fault.
std::unique_ptr<System::Parts> build(const Scene& scene, int threads);

}  // namespace sim
