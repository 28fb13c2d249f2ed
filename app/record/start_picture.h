// The picture of a start that is refused, as bodies of a contact cross or touch there.
#pragma once

#include <vector>

#include "app/options/options.h"
#include "sim/math/vec3.h"

namespace app {

// Frame 0 of the scene that the options name, with a dot at each of the places [m].
void draw_start(const Options& options, const std::vector<sim::Vec3>& places);

}  // namespace app
