// The keys that a scene file, a settings file or an override gives: a flat list of paths and values, each checked
// against the key table. Lists of several sources are laid over each other.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/options/options.h"
#include "app/scene/keys.h"

namespace app {

struct Item {
  std::string path;  // "body.0.material.young"
  const Key* key = nullptr;
  Indices indices = {};
  Value value;        // of tables: nothing of meaning; of an entry of a list: its index
  int dimension = 0;  // of points: how many numbers were given; else 0
  Place place;
};

// What one source gives, parents before what they hold.
struct Layer {
  std::vector<Item> items;
  std::vector<std::string> lists;  // paths of the lists that were given as a whole: "body.0.pin"
  std::vector<Mistake> mistakes;   // what was refused, and is not among the items
};

// Throw SceneError for what cannot be read at all: no file, no TOML.
Layer read_layer(const std::filesystem::path& file);
// The same for TOML text; `name` stands for the file in messages.
Layer read_layer(std::string_view text, const std::string& name);
Layer read_layer(const Override& override);

// Tables are merged; a value, and a list that is given as a whole, replaces what was there. So does a key that excludes
// another (time.step and time.substeps).
void lay_over(Layer& lower, Layer layer);

}  // namespace app
