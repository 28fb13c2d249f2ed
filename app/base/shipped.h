// The scenes that come with the program: beside it where it was installed, in the sources where it was built.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace app {

// The folder with scenes/ and meshes/, found from where the program is: PREFIX/share/ritz for PREFIX/bin/ritz, assets
// for build/ritz. Empty where there is neither.
std::filesystem::path shipped_folder();

// The bare names of the scenes, in order: "bear", "benchmarks/cook", "lectures/09-x-ray".
std::vector<std::string> shipped_scenes();

// The file of a scene that is called by a bare name, or the folder of the lecture for "lectures", unless there is a
// file or a folder of this name. Everything else is returned as it is.
std::filesystem::path find_scene(const std::filesystem::path& scene);

}  // namespace app
