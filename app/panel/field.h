// The widget of one key.
#pragma once

#include <optional>
#include <string>

#include "app/scene/keys.h"

namespace app {

// The value under the mouse or the keys, until it is let go: dragging shows numbers, letting go changes the scene.
struct Edit {
  std::string path;
  Value value;
};

// Draws the value of the key at `path`; none where it is absent (then a text is asked for). Returns the new value as
// TOML once it was let go. `edit` is shared by all fields. The last item of Dear ImGui is the widget.
std::optional<std::string> draw_field(const Key& key, const std::string& path, const std::optional<Value>& value,
                                      int dimension, std::optional<Edit>& edit);

}  // namespace app
