// Scene files: TOML in, Document out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/options/options.h"
#include "app/scene/document.h"
#include "app/scene/scene_items.h"

namespace app {

// Reads a scene, lays the settings file (empty path: none) and then the overrides over it, checks every key against
// the key table, fills every default in and makes the meshes. Throws SceneError with all that is wrong.
Document load_scene(const std::filesystem::path& scene, const std::filesystem::path& settings = {},
                    const std::vector<Override>& overrides = {});

// The same in two steps, for who changes keys again and again: what the files say is read once. Throw SceneError.
Layer read_scene(const std::filesystem::path& scene, const std::filesystem::path& settings);
Document load_scene(Layer layer, const std::filesystem::path& scene, const std::vector<Override>& overrides);

}  // namespace app
