// What must hold between the keys of a scene. All throw sim::InputError with the path of the key at fault.
#pragma once

#include <vector>

#include "app/scene/scene_items.h"
#include "sim/mesh/input_error.h"

namespace app {

// Required keys are there; of alternatives there is one; lists have no gaps.
void check_presence(const std::vector<Item>& items, const Places& places);

// Points have as many numbers as the scene has dimensions, and keys of the other dimension are absent.
void check_dimension(const std::vector<Item>& items, int dimension);

// Names are unique and refer to something; keyframes are in order; the camera looks somewhere.
void check_consistency(const std::vector<Item>& items, const Document& document);

}  // namespace app
