#include "app/scene/scene_checks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "app/base/nearest.h"
#include "app/scene/caption_names.h"
#include "app/scene/exhibits.h"
#include "sim/mesh/input_error.h"
#include "sim/mesh/locate.h"

namespace app {
namespace {

std::string key_path(std::string_view table, std::string_view name) {
  return table.empty() ? std::string(name) : std::string(table) + "." + std::string(name);
}

bool given(const Places& places, const std::string& path, const Key& key) {
  return places.contains(path) || (key.kind == Kind::list && places.contains(path + ".0"));
}

// Something must be seen: a body, or what an exhibit shows without one.
void check_subject(const Places& places, Mistakes& mistakes) {
  const auto given = [&](const std::string& list) { return places.contains(list) || places.contains(list + ".0"); };
  if (!given("body") && !given("exhibit"))
    mistakes.refuse("", "'body' is missing: " + std::string(find_key("body[]")->meaning));
}

// `table` is the path of a table that is present, `pattern` its pattern.
void check_required(std::string_view table, std::string_view pattern, const Places& places, Mistakes& mistakes) {
  for (const Key& key : keys()) {
    const std::string path = key_path(table, last_name(key.path));
    if (!key.required || parent(key.path) != pattern || given(places, path, key)) continue;
    mistakes.refuse(std::string(table),
                    "'" + std::string(last_name(key.path)) + "' is missing: " + std::string(key.meaning));
  }
}

void check_alternatives(const Item& item, const Places& places, Mistakes& mistakes) {
  for (const Alternatives& group : alternatives()) {
    if (item.key->path != group.table) continue;
    std::string names;
    int count = 0;
    for (const std::string_view name : group.names) {
      names.append(names.empty() ? "" : ", ").append(name);
      if (places.contains(key_path(item.path, name))) ++count;
    }
    if (count > 1 || (count == 0 && group.required)) {
      mistakes.refuse(item.path, (group.required ? "must have exactly one of " : "can have only one of ") + names);
    }
  }
}

// Entries of a list are numbered without a gap.
void check_position(const Item& item, const Places& places, Mistakes& mistakes) {
  if (item.key->kind != Kind::list || std::get<std::int64_t>(item.value) == 0) return;
  const std::string before = key_path(parent(item.path), std::to_string(std::get<std::int64_t>(item.value) - 1));
  if (!places.contains(before)) mistakes.refuse(item.path, "there is no " + before + " that it could follow");
}

// `list` is the pattern of a list of names, as in "body[].name".
template <class List>
void check_unique(const List& list, const std::string& path, Mistakes& mistakes) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (seen.insert(list[i].name).second) continue;
    mistakes.refuse(path + "." + std::to_string(i) + ".name", "is the name of another one already");
  }
}

void check_group(const sim::Mesh& mesh, const sim::InGroup& group, sim::GroupPart part, const std::string& path,
                 Mistakes& mistakes) {
  try {
    sim::find_group(mesh, group, part);
  } catch (const sim::InputError& error) {
    std::vector<std::string_view> names;
    for (const sim::Group& known : mesh.groups) {
      if (known.name != group.name) names.push_back(known.name);
    }
    mistakes.refuse(path, error.what() + suggestion(group.name, names));
  }
}

// A box or a sphere at rest has something of the mesh in it.
void check_place(const sim::Mesh& mesh, const sim::Region& region, sim::GroupPart part, const std::string& path,
                 Mistakes& mistakes) {
  const bool nodes = part == sim::GroupPart::nodes;
  if (nodes ? sim::nodes_in(mesh, region).empty() : sim::facets_in(mesh, region).cols() == 0)
    mistakes.refuse(path, std::string("there is no ") + (nodes ? "node" : "boundary facet") +
                              " of the body in this region; " + sim::span_text(mesh));
}

void check_region(const sim::Mesh& mesh, const sim::Region& region, sim::GroupPart part, const std::string& path,
                  Mistakes& mistakes) {
  const auto* group = std::get_if<sim::InGroup>(&region);
  if (group == nullptr) return check_place(mesh, region, part, path, mistakes);
  if (group->name.empty() && group->dimension) {
    mistakes.refuse(path + ".dimension", "is for a group only");
  } else {
    check_group(mesh, *group, part, path + ".group", mistakes);
  }
}

// `path` is the list of keyframes.
template <class List>
void check_times(const List& keyframes, const std::string& path, Mistakes& mistakes) {
  for (std::size_t i = 1; i < keyframes.size(); ++i) {
    if (keyframes[i].t <= keyframes[i - 1].t) {
      mistakes.refuse(path + "." + std::to_string(i) + ".0", "must be later than the pose before it");
    }
  }
}

void check_body(const sim::Body& body, const std::string& path, Mistakes& mistakes) {
  for (std::size_t i = 0; i < body.pins.size(); ++i) {
    const std::string pin = path + ".pin." + std::to_string(i);
    check_region(body.mesh, body.pins[i].where, sim::GroupPart::nodes, pin, mistakes);
    check_times(body.pins[i].motion, pin + ".motion.keyframes", mistakes);
  }
  for (std::size_t i = 0; i < body.loads.tractions.size(); ++i) {
    check_region(body.mesh, body.loads.tractions[i].where, sim::GroupPart::facets,
                 path + ".traction." + std::to_string(i), mistakes);
  }
  for (std::size_t i = 0; i < body.loads.pressures.size(); ++i) {
    if (!body.loads.pressures[i].where) continue;
    check_region(body.mesh, *body.loads.pressures[i].where, sim::GroupPart::facets,
                 path + ".pressure." + std::to_string(i), mistakes);
  }
  for (std::size_t i = 1; i < body.materials.size(); ++i) {
    check_group(body.mesh, {body.materials[i].group}, sim::GroupPart::elements,
                path + ".region." + std::to_string(i - 1) + ".group", mistakes);
  }
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void check_body_name(const Document& document, const std::string& name, const std::string& path, Mistakes& mistakes) {
  const sim::Scene& scene = document.scene;
  if (scene.bodies.empty() && document.exhibits.empty()) return;  // refused already
  if (std::ranges::find(scene.bodies, name, &sim::Body::name) != scene.bodies.end()) return;
  std::vector<std::string> names;
  for (const sim::Body& body : scene.bodies) names.push_back(body.name);
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::string known = names.empty() ? " and no other" : "; there are: " + listed(names);
  mistakes.refuse(path, "there is no body \"" + name + "\"" + known + suggestion(name, views));
}

// `path` is of what names the body and the place at rest.
void check_point(const Document& document, const std::string& name, const Vec3& at, const std::string& path,
                 Mistakes& mistakes) {
  const std::vector<sim::Body>& bodies = document.scene.bodies;
  check_body_name(document, name, path + ".body", mistakes);
  const auto body = std::ranges::find(bodies, name, &sim::Body::name);
  if (body == bodies.end() || body->mesh.element_count() == 0 || sim::locate(body->mesh, at)) return;
  mistakes.refuse(path + ".at", "the point is outside the body; " + sim::span_text(body->mesh));
}

// A kind has its own keys among those of all exhibits.
void check_exhibits(const std::vector<Item>& items, const Document& document, Mistakes& mistakes) {
  for (const Item& item : items) {
    if (parent(item.key->path) != "exhibit[]") continue;
    const std::string& kind = document.exhibits[static_cast<std::size_t>(item.indices[0])].kind;
    if (exhibit_has(kind, last_name(item.key->path))) continue;
    const std::vector<std::string_view>& known = find_exhibit_kind(kind)->keys;
    const std::vector<std::string> names(known.begin(), known.end());
    mistakes.refuse(item.path, "is no key of the exhibit \"" + kind + "\"; it has: " + listed(names));
  }
}

void check_picture(const Document& document, Mistakes& mistakes) {
  const Camera& camera = document.camera;
  if (camera.eye && camera.target) {
    const Vec3 view = *camera.target - *camera.eye;
    if (view.norm() == 0) {
      mistakes.refuse("camera.target", "must differ from camera.eye");
    } else if (view.normalized().cross(up_of(camera, document.scene.world.gravity)).norm() < 1e-6) {
      mistakes.refuse(camera.up ? "camera.up" : "camera.eye",
                      "up must not lie along the line from camera.eye to camera.target; set camera.up");
    }
  }
  if (!camera.follow.empty()) check_body_name(document, camera.follow, "camera.follow", mistakes);
  check_times(camera.keyframes, "camera.keyframes", mistakes);
  for (const std::string& name : caption_names(document.look.caption)) {
    if (find_caption_value(name)) continue;
    const std::vector<std::string> known = known_caption_names();
    const std::vector<std::string_view> views(known.begin(), known.end());
    mistakes.refuse("look.caption",
                    "{" + name + "} is not known; known are " + listed(known) + suggestion(name, views));
  }
  if (document.look.range && (*document.look.range)[0] >= (*document.look.range)[1]) {
    mistakes.refuse("look.range", "must be [low, high] with low < high");
  }
}

}  // namespace

void check_presence(const std::vector<Item>& items, const Places& places, Mistakes& mistakes) {
  check_required("", "", places, mistakes);
  check_subject(places, mistakes);
  for (const Item& item : items) {
    if (item.key->kind != Kind::table && item.key->kind != Kind::list) continue;
    check_position(item, places, mistakes);
    check_required(item.path, item.key->path, places, mistakes);
    check_alternatives(item, places, mistakes);
  }
}

void check_dimension(const std::vector<Item>& items, int dimension, Mistakes& mistakes) {
  const std::string numbers = std::to_string(dimension) + " numbers";
  const std::string scene = dimension == 2 ? "the scene is 2D, as all its meshes are" : "the scene is 3D";
  for (const Item& item : items) {
    if (item.key->dimension != 0 && item.key->dimension != dimension) {
      mistakes.refuse(item.path, "is for " + std::to_string(item.key->dimension) + "D only, and " + scene);
    }
    if (item.dimension != 0 && item.dimension != dimension) {
      const bool one = item.key->kind == Kind::point || item.key->kind == Kind::direction;
      const bool rows = item.key->kind == Kind::matrix;
      mistakes.refuse(item.path, (one    ? "must have " + numbers
                                  : rows ? "must have rows of " + numbers
                                         : "must have points of " + numbers) +
                                     ": " + scene);
    }
    if (item.key->kind == Kind::axis && dimension == 2) {
      const auto& axis = std::get<std::vector<double>>(item.value);
      if (axis[0] != 0 || axis[1] != 0) mistakes.refuse(item.path, "must be along [0, 0, 1]: " + scene);
    }
  }
}

void check_consistency(const std::vector<Item>& items, const Document& document, Mistakes& mistakes) {
  const sim::Scene& scene = document.scene;
  check_unique(scene.bodies, "body", mistakes);
  check_unique(scene.probes, "probe", mistakes);
  check_unique(scene.obstacles, "obstacle", mistakes);
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i)
    check_times(scene.obstacles[i].motion, "obstacle." + std::to_string(i) + ".motion.keyframes", mistakes);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const std::string path = "body." + std::to_string(i);
    const sim::Body& body = scene.bodies[i];
    if (body.mesh.element_count() == 0) continue;  // refused already
    check_body(body, path, mistakes);
    for (std::size_t k = 0; k < body.loads.forces.size(); ++k)
      check_point(document, body.name, body.loads.forces[k].at, path + ".force." + std::to_string(k), mistakes);
  }
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    check_point(document, scene.probes[i].body, scene.probes[i].at, "probe." + std::to_string(i), mistakes);
  }
  for (std::size_t i = 0; i < scene.springs.size(); ++i)
    check_point(document, scene.springs[i].body, scene.springs[i].at, "spring." + std::to_string(i), mistakes);
  for (std::size_t i = 0; i < scene.contacts.size(); ++i)
    for (const std::string& name : scene.contacts[i].between)
      check_body_name(document, name, "contact." + std::to_string(i) + ".between", mistakes);
  check_exhibits(items, document, mistakes);
  check_picture(document, mistakes);
}

}  // namespace app
