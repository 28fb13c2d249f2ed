#include "app/base/shipped.h"

#include <algorithm>

namespace app {
namespace {

namespace fs = std::filesystem;

fs::path scenes_folder() {
  const fs::path folder = shipped_folder();
  return folder.empty() ? fs::path() : folder / "scenes";
}

}  // namespace

fs::path shipped_folder() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none).parent_path();
  for (const char* const beside : {"../share/ritz", "../assets"}) {
    const fs::path folder = (program / beside).lexically_normal();
    if (fs::is_directory(folder / "scenes", none)) return folder;
  }
  return {};
}

std::vector<std::string> shipped_scenes() {
  const fs::path folder = scenes_folder();
  std::vector<std::string> names;
  if (folder.empty()) return names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    names.push_back(entry.path().lexically_relative(folder).replace_extension().generic_string());
  }
  // Those of a folder after those beside it.
  std::ranges::sort(names, {}, [](const std::string& name) {
    return std::pair(std::ranges::count(name, '/'), std::string_view(name));
  });
  return names;
}

fs::path find_scene(const fs::path& scene) {
  std::error_code none;
  const fs::path folder = scenes_folder();
  if (folder.empty() || scene.empty() || scene.is_absolute() || fs::is_regular_file(scene, none)) return scene;
  fs::path shipped = folder / scene;
  shipped += ".toml";
  return fs::is_regular_file(shipped, none) ? shipped : scene;
}

}  // namespace app
