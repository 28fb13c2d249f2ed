#include "app/base/shipped.h"

#include <algorithm>

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* deck = "lectures";  // a folder whose files are pages

void add_scenes(const fs::path& folder, const std::string& before, std::vector<std::string>& names) {
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none))
    if (entry.path().extension() == ".toml") names.push_back(before + entry.path().stem().string());
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
  const fs::path folder = shipped_folder();
  std::vector<std::string> names;
  if (folder.empty()) return names;
  add_scenes(folder / "scenes", "", names);
  add_scenes(folder / "scenes/benchmarks", "benchmarks/", names);
  add_scenes(folder / deck, deck + std::string("/"), names);
  // Those of a folder after those beside it.
  std::ranges::sort(names, {}, [](const std::string& name) {
    return std::pair(std::ranges::count(name, '/'), std::string_view(name));
  });
  return names;
}

fs::path find_scene(const fs::path& scene) {
  std::error_code none;
  const fs::path folder = shipped_folder();
  if (folder.empty() || scene.empty() || scene.is_absolute() || fs::exists(scene, none)) return scene;
  if (scene == deck) return folder / deck;
  for (fs::path shipped : {folder / "scenes" / scene, folder / scene}) {
    shipped += ".toml";
    if (fs::is_regular_file(shipped, none)) return shipped;
  }
  return scene;
}

}  // namespace app
