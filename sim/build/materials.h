// Which material each element of a body has.
#pragma once

#include <vector>

#include "sim/scene.h"

namespace sim {

// Numbers in body.materials: 0 is the body's own, later ones override groups. `number`: of the body, for messages.
std::vector<int> material_of_elements(const Body& body, std::size_t number);

}  // namespace sim
