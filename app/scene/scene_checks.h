// What must hold between the keys of a scene. Each keeps all that does not.
#pragma once

#include <vector>

#include "app/scene/mistakes.h"
#include "app/scene/scene_items.h"

namespace app {

// Required keys are there; of alternatives there is one; lists have no gaps.
void check_presence(const std::vector<Item>& items, const Places& places, Mistakes& mistakes);

// Points have as many numbers as the scene has dimensions, and keys of the other dimension are absent.
void check_dimension(const std::vector<Item>& items, int dimension, Mistakes& mistakes);

// Names are unique and refer to something; keyframes are in order; the camera looks somewhere.
void check_consistency(const std::vector<Item>& items, const Document& document, Mistakes& mistakes);

}  // namespace app
