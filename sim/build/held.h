// Whether a body at rest has an equilibrium, or a load moves it as a whole.
#pragma once

#include <string>

#include "sim/solve/model.h"

namespace sim {

// For statics: names the motions of a rigid body that nothing resists although the load at the start does work in them.
// Empty where there are none, or where barriers may hold what lies on them.
std::string moved_as_a_whole(const Model& model, const std::vector<Spring>& springs);

}  // namespace sim
