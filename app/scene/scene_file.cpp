#include "app/scene/scene_file.h"

#include <algorithm>

#include "app/base/number_text.h"
#include "app/mesh/error.h"
#include "app/mesh/positions.h"
#include "app/scene/scene_checks.h"
#include "app/scene/scene_items.h"
#include "app/scene/snapshots.h"
#include "sim/element/element.h"
#include "sim/mesh/boundary.h"
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

// `path` is that of the body.
void make_body(MeshSpec& spec, const std::string& path, sim::Body& body, std::vector<std::string>& remarks) {
  try {
    body.mesh = make_mesh(spec, remarks);
  } catch (const sim::InputError& error) {
    throw sim::InputError(path + "." + error.key, error.what());
  } catch (const FileError& error) {
    throw sim::InputError(path + (spec.source == MeshSource::surface ? ".mesh.surface" : ".mesh.file"), error.what());
  }
}

// A body that something is wrong with gets no mesh, and neither does one that only stands in a gap of the list.
void make_bodies(Document& document, const std::filesystem::path& folder, const Places& places, Mistakes& mistakes) {
  sim::Scene& scene = document.scene;
  scene.dimension = 2;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const std::string path = "body." + std::to_string(i);
    sim::Body& body = scene.bodies[i];
    MeshSpec& spec = document.meshes[i];
    if (body.name.empty()) body.name = "body" + std::to_string(i);
    if (mistakes.in_part_of(path) || !places.contains(path)) continue;
    if (!spec.file.empty()) spec.file = folder / spec.file;
    if (!spec.skin_file.empty()) spec.skin_file = folder / spec.skin_file;
    std::vector<std::string> remarks;
    mistakes.collect([&] { make_body(spec, path, body, remarks); });
    for (const std::string& remark : remarks) document.remarks.push_back(body.name + ": " + remark);
    if (body.mesh.dimension() == 3) scene.dimension = 3;
  }
}

// Where nodes start that a file tells.
void read_start(std::filesystem::path& file, const std::filesystem::path& folder, int dimension,
                const std::string& path, sim::Start& start) {
  if (file.empty()) return;
  file = folder / file;
  try {
    start.nodes = read_positions(file, dimension);
  } catch (const FileError& error) {
    throw sim::InputError(path + ".start.file", error.what());
  }
}

void read_starts(Document& document, const std::filesystem::path& folder, Mistakes& mistakes) {
  for (std::size_t i = 0; i < document.start_files.size(); ++i) {
    mistakes.collect([&] {
      read_start(document.start_files[i], folder, document.scene.dimension, "body." + std::to_string(i),
                 document.scene.bodies[i].start);
    });
  }
}

void read_bases(Document& document, const std::filesystem::path& folder, Mistakes& mistakes) {
  for (std::size_t i = 0; i < document.basis_folders.size(); ++i) {
    std::filesystem::path& from = document.basis_folders[i];
    if (document.without_basis[i]) document.scene.bodies[i].basis.reset();
    if (from.empty() || !document.scene.bodies[i].basis) continue;
    from = folder / from;
    mistakes.collect([&] {
      try {
        document.scene.bodies[i].basis->snapshots = read_snapshots(from, document.scene, i);
      } catch (const FileError& error) {
        throw sim::InputError("body." + std::to_string(i) + ".basis.from", error.what());
      }
    });
  }
}

void place_body(const MeshSpec& spec, int dimension, const std::string& path, sim::Mesh& mesh) {
  try {
    place_mesh(spec, dimension, mesh);
  } catch (const sim::InputError& error) {
    throw sim::InputError(path + "." + error.key, error.what());
  }
}

// In space, triangles are a membrane. A surface without an edge is what programs write of a solid, and the default
// thickness is that of plane strain: neither may be what is meant.
void note_membrane(const sim::Body& body, const MeshSpec& spec, bool has_thickness, std::vector<std::string>& remarks) {
  if (body.mesh.dimension() == 2 || sim::info(body.mesh.kind).dimension == 3) return;
  const bool is_closed = spec.source == MeshSource::file && sim::boundary_facets(body.mesh).cols() == 0;
  if (!is_closed && has_thickness) return;
  std::string remark = body.name + ": ";
  remark += is_closed ? "a closed surface, taken as a hollow membrane of thickness "
                      : "a surface in space, taken as a membrane of thickness ";
  append_number(remark, body.thickness);
  remarks.push_back(remark + " m (body.thickness)" + (is_closed ? "; mesh.surface fills it with tets" : ""));
}

void place_bodies(Document& document, const Places& places, Mistakes& mistakes) {
  for (std::size_t i = 0; i < document.meshes.size(); ++i) {
    const std::string path = "body." + std::to_string(i);
    if (mistakes.in_part_of(path)) continue;
    sim::Body& body = document.scene.bodies[i];
    mistakes.collect([&] { place_body(document.meshes[i], document.scene.dimension, path, body.mesh); });
    note_membrane(body, document.meshes[i], places.contains(path + ".thickness"), document.remarks);
  }
}

// A floor that the scene gives hides what is below it.
void note_floor(const Document& document, std::vector<std::string>& remarks) {
  const std::optional<double>& height = document.look.ground_height;
  if (!height || !document.look.ground || document.scene.dimension == 2) return;
  const Vec3 up = up_of(document.camera, document.scene.world.gravity);
  for (const sim::Body& body : document.scene.bodies) {
    const auto heights = up.transpose() * body.mesh.X;
    const double lowest = heights.minCoeff(), hidden = *height - lowest;
    if (hidden <= 1e-3 * (heights.maxCoeff() - lowest)) continue;
    std::string remark = "look.ground_height: the floor hides " + body.name + ", which begins ";
    append_number(remark, hidden);
    remarks.push_back(remark + " m below it");
  }
}

// `path` is that of the obstacle.
void make_obstacle(ObstacleMesh& mesh, int dimension, const std::string& path, sim::Obstacle& obstacle,
                   std::vector<std::string>& remarks) {
  try {
    obstacle.shape = make_surface(mesh, dimension, remarks);
  } catch (const sim::InputError& error) {
    throw sim::InputError(path + "." + error.key, error.what());
  } catch (const FileError& error) {
    throw sim::InputError(path + ".mesh.file", error.what());
  }
}

void name_obstacles(std::vector<sim::Obstacle>& obstacles) {
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    if (obstacles[i].name.empty()) obstacles[i].name = "obstacle" + std::to_string(i);
}

void make_obstacles(Document& document, const std::filesystem::path& folder, Mistakes& mistakes) {
  for (std::size_t i = 0; i < document.scene.obstacles.size(); ++i) {
    const std::string path = "obstacle." + std::to_string(i);
    sim::Obstacle& obstacle = document.scene.obstacles[i];
    ObstacleMesh& mesh = document.obstacle_meshes[i];
    if (mistakes.in_part_of(path) || !mesh.is_given()) continue;
    if (!mesh.spec.file.empty()) mesh.spec.file = folder / mesh.spec.file;
    std::vector<std::string> remarks;
    mistakes.collect([&] { make_obstacle(mesh, document.scene.dimension, path, obstacle, remarks); });
    for (const std::string& remark : remarks) document.remarks.push_back(obstacle.name + ": " + remark);
  }
}

// Whether every body has its mesh, so that the dimension of the scene is known. A page of exhibits alone is plane.
bool all_are_made(const Document& document) {
  const std::vector<sim::Body>& bodies = document.scene.bodies;
  if (bodies.empty()) return !document.exhibits.empty();
  return std::ranges::none_of(bodies, [](const sim::Body& body) { return body.mesh.element_count() == 0; });
}

Document make_document(const std::vector<Item>& items, const std::filesystem::path& scene, const Places& places,
                       Mistakes& mistakes) {
  Document document;
  document.folder = scene.parent_path();
  check_presence(items, places, mistakes);
  apply(items, document);
  choose_substeps(document.scene.time, places);
  name_obstacles(document.scene.obstacles);
  mistakes.next_stage();
  make_bodies(document, document.folder, places, mistakes);
  mistakes.next_stage();
  const bool made = all_are_made(document);
  if (made) check_dimension(items, document.scene.dimension, mistakes);
  mistakes.next_stage();
  if (made) place_bodies(document, places, mistakes);
  if (made) make_obstacles(document, document.folder, mistakes);
  if (made) read_starts(document, document.folder, mistakes);
  if (made) read_bases(document, document.folder, mistakes);
  check_consistency(items, document, mistakes);
  if (mistakes.empty()) note_floor(document, document.remarks);
  return document;
}

}  // namespace

Layer read_scene(const std::filesystem::path& scene, const std::filesystem::path& settings) {
  Layer layer = read_layer(scene);
  if (!settings.empty()) lay_over(layer, read_layer(settings));
  return layer;
}

Document load_scene(Layer layer, const std::filesystem::path& scene, const std::vector<Override>& overrides) {
  for (const Override& override : overrides) lay_over(layer, read_layer(override));
  Places places = {{"", {scene.string(), ""}}};
  for (const Item& item : layer.items) places.emplace(item.path, item.place);
  for (const Mistake& mistake : layer.mistakes) places.emplace(mistake.path, mistake.place);  // given, though wrongly
  Mistakes mistakes(std::move(layer.mistakes), places);
  Document document = make_document(layer.items, scene, places, mistakes);
  if (!mistakes.empty()) throw mistakes.error(scene.string());
  document.places = std::move(places);
  return document;
}

Document load_scene(const std::filesystem::path& scene, const std::filesystem::path& settings,
                    const std::vector<Override>& overrides) {
  return load_scene(read_scene(scene, settings), scene, overrides);
}

}  // namespace app
