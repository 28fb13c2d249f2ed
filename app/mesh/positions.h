// Positions of nodes as a text file.
#pragma once

#include <filesystem>
#include <vector>

#include "sim/math/vec3.h"

namespace app {

// One node on each line, `dimension` numbers [m]; what follows a # is a comment. In the plane the third number is 0.
// Throws FileError.
std::vector<sim::Vec3> read_positions(const std::filesystem::path& path, int dimension);

}  // namespace app
