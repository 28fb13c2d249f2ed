#include "app/scene/scene_file.h"

#include "app/mesh/error.h"
#include "app/mesh/positions.h"
#include "app/scene/scene_checks.h"
#include "app/scene/scene_items.h"
#include "sim/mesh/input_error.h"
#include "sim/time/scheme.h"

namespace app {
namespace {

// Fills the document in the order of the key table, so that what a key depends on is there before it.
void apply(const std::vector<Item>& items, Document& document) {
  for (const Key& key : keys()) {
    for (const Item& item : items) {
      if (item.key != &key || key.kind == Kind::table) continue;
      if (key.kind != Kind::list) {
        key.binding.set(document, item.indices, item.value);
        continue;
      }
      const std::int64_t index = std::get<std::int64_t>(item.value);
      const std::int64_t count = std::get<std::int64_t>(*key.binding.get(document, item.indices));
      if (index >= count) key.binding.set(document, item.indices, index + 1);
    }
  }
}

// Explicit schemes take as many steps as stability needs, unless told otherwise.
void choose_substeps(sim::Time& time, const Places& places) {
  if (places.contains("time.substeps") || places.contains("time.step")) return;
  if (sim::find_scheme(time.integrator)->is_explicit()) time.substeps = 0;
}

void make_bodies(Document& document, const std::filesystem::path& folder) {
  sim::Scene& scene = document.scene;
  scene.dimension = 2;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const std::string path = "body." + std::to_string(i);
    sim::Body& body = scene.bodies[i];
    MeshSpec& spec = document.meshes[i];
    if (body.name.empty()) body.name = "body" + std::to_string(i);
    if (spec.source == MeshSource::file) spec.file = folder / spec.file;
    std::vector<std::string> remarks;
    try {
      body.mesh = make_mesh(spec, remarks);
    } catch (const sim::InputError& error) {
      throw sim::InputError(path + "." + error.key, error.what());
    } catch (const FileError& error) {
      throw sim::InputError(path + ".mesh.file", error.what());
    }
    for (const std::string& remark : remarks) document.remarks.push_back(body.name + ": " + remark);
    if (body.mesh.dimension() == 3) scene.dimension = 3;
  }
}

// Where nodes start that a file tells.
void read_starts(Document& document, const std::filesystem::path& folder) {
  for (std::size_t i = 0; i < document.start_files.size(); ++i) {
    std::filesystem::path& file = document.start_files[i];
    if (file.empty()) continue;
    file = folder / file;
    try {
      document.scene.bodies[i].start.nodes = read_positions(file, document.scene.dimension);
    } catch (const FileError& error) {
      throw sim::InputError("body." + std::to_string(i) + ".start.file", error.what());
    }
  }
}

void place_bodies(Document& document) {
  for (std::size_t i = 0; i < document.meshes.size(); ++i) {
    try {
      place_mesh(document.meshes[i], document.scene.dimension, document.scene.bodies[i].mesh);
    } catch (const sim::InputError& error) {
      throw sim::InputError("body." + std::to_string(i) + "." + error.key, error.what());
    }
  }
}

Document make_document(const std::vector<Item>& items, const std::filesystem::path& scene, Places& places) {
  Document document;
  for (const Item& item : items) places.emplace(item.path, item.place);
  check_presence(items, places);
  apply(items, document);
  choose_substeps(document.scene.time, places);
  make_bodies(document, scene.parent_path());
  check_dimension(items, document.scene.dimension);
  place_bodies(document);
  read_starts(document, scene.parent_path());
  check_consistency(items, document);
  return document;
}

}  // namespace

std::vector<Item> read_scene(const std::filesystem::path& scene, const std::filesystem::path& settings) {
  std::vector<Item> items;
  lay_over(items, read_layer(scene));
  if (!settings.empty()) lay_over(items, read_layer(settings));
  return items;
}

Document load_scene(std::vector<Item> items, const std::filesystem::path& scene,
                    const std::vector<Override>& overrides) {
  for (const Override& override : overrides) lay_over(items, read_layer(override));
  Places places = {{"", {scene.string(), ""}}};
  try {
    Document document = make_document(items, scene, places);
    document.places = std::move(places);
    return document;
  } catch (const sim::InputError& error) {
    throw located(error, places);
  }
}

Document load_scene(const std::filesystem::path& scene, const std::filesystem::path& settings,
                    const std::vector<Override>& overrides) {
  return load_scene(read_scene(scene, settings), scene, overrides);
}

}  // namespace app
