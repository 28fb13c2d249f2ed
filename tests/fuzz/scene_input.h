// One input of the fuzzer for scene files, and what must hold for whatever it is: a document that can be written and
// read again as the same, or a SceneError.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "app/base/output_file.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_items.h"
#include "app/scene/scene_text.h"

namespace app {

// Meshes that are merely large are no mistake: they are left out, as they take long.
inline bool is_small(const std::vector<Item>& items) {
  for (const Item& item : items) {
    const std::string_view path = item.key->path;
    if (path == "body[].mesh.refine" && std::get<std::int64_t>(item.value) > 1) return false;
    if (path != "body[].mesh.cells") continue;
    for (const double n : std::get<std::vector<double>>(item.value))
      if (n > 6) return false;
  }
  return true;
}

// True when a document was read, false when the input was refused. `file`: a name to write the input to.
inline bool try_scene_input(std::string_view input, const std::filesystem::path& file) {
  try {
    if (!is_small(read_layer(input, "fuzz.toml").items)) return false;
    write_atomically(file, input, false);
    const Document document = load_scene(file);
    const std::string text = scene_toml(document, file.parent_path());
    write_atomically(file, text, false);
    if (scene_toml(load_scene(file), file.parent_path()) != text) std::abort();
    return true;
  } catch (const SceneError&) {
    return false;
  }
}

}  // namespace app
