// A deck: the scenes of a folder, in the order of their names.
#pragma once

#include <filesystem>
#include <vector>

namespace app {

// The scene itself where it is a file; of a folder every *.toml in it. Throws SceneError when there is none.
std::vector<std::filesystem::path> pages_of(const std::filesystem::path& scene);

}  // namespace app
