// What acts on bodies from outside at places that a scene names.
#pragma once

#include <string>
#include <vector>

#include "sim/build/parts.h"

namespace sim {

// The body and the material point that a key names. Throws InputError.
ProbePlace find_point(const Model& model, const std::string& key, const std::string& body, const Vec3& at);

// Tractions, pressures and point forces on body b, then springs. Throw InputError.
void add_loads(Model& model, std::size_t b);
void add_springs(Model& model, const std::vector<Spring>& springs);

}  // namespace sim
