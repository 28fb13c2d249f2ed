#include "app/scene/deck.h"

#include <algorithm>

#include "app/scene/scene_error.h"

namespace app {

std::vector<std::filesystem::path> pages_of(const std::filesystem::path& scene) {
  if (!std::filesystem::is_directory(scene)) return {scene};
  std::vector<std::filesystem::path> pages;
  for (const auto& entry : std::filesystem::directory_iterator(scene))
    if (entry.is_regular_file() && entry.path().extension() == ".toml") pages.push_back(entry.path());
  if (pages.empty()) throw SceneError(scene.string() + ": this folder has no scene file (*.toml)");
  std::ranges::sort(pages);
  return pages;
}

}  // namespace app
