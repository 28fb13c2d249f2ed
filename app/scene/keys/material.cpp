// Keys of the materials of a body: of the whole, and of regions that override it.
#include "app/scene/keys/binding.h"
#include "app/scene/keys/choices.h"

namespace app {
namespace {

constexpr auto material_of = [](auto& d, const Indices& i) -> auto& {
  return body_of(d, i).materials[0];
};
constexpr auto region_of = [](auto& d, const Indices& i) -> auto& {
  return body_of(d, i).materials[1 + i[1]];
};

// A new region starts with the material of the whole body.
constexpr Binding regions = {
    [](const Document& d, const Indices& i) { return std::optional<Value>(std::ssize(body_of(d, i).materials) - 1); },
    [](Document& d, const Indices& i, const Value& n) {
      std::vector<sim::MaterialSpec>& materials = body_of(d, i).materials;
      const sim::MaterialSpec whole = materials[0];
      materials.resize(1 + std::get<std::int64_t>(n), whole);
    }};

// The four constants of a material; `path` holds model, young, poisson, density in this order.
template <auto owner>
std::vector<Key> constants(const std::array<std::string_view, 4>& path) {
  return {
      {.path = path[0],
       .kind = Kind::choice,
       .choices = material_names,
       .meaning = "Energy density of the material.",
       .binding = field<owner, &sim::MaterialSpec::model>},
      {.path = path[1],
       .kind = Kind::number,
       .unit = "Pa",
       .range = above(0),
       .meaning = "Young's modulus: stiffness. Jelly 1e4, rubber 1e6, wood 1e10, steel 2e11.",
       .binding = field<owner, &sim::MaterialSpec::young>},
      {.path = path[2],
       .kind = Kind::number,
       .range = inside(-1, 0.5),
       .meaning = "Poisson's ratio: how much it thins when stretched; close to 0.5 it keeps its volume.",
       .binding = field<owner, &sim::MaterialSpec::poisson>},
      {.path = path[3],
       .kind = Kind::number,
       .unit = "kg/m^3",
       .range = above(0),
       .meaning = "Mass per volume at rest.",
       .binding = field<owner, &sim::MaterialSpec::density>},
  };
}

}  // namespace

std::vector<Key> material_keys() {
  std::vector<Key> table = {{.path = "body[].material", .kind = Kind::table, .meaning = "Material of the body."}};
  std::vector<Key> whole = constants<material_of>(
      {"body[].material.model", "body[].material.young", "body[].material.poisson", "body[].material.density"});
  append(table, whole);

  table.push_back({.path = "body[].region[]",
                   .kind = Kind::list,
                   .meaning = "A part of the body with a material of its own.",
                   .binding = regions});
  table.push_back({.path = "body[].region[].group",
                   .kind = Kind::text,
                   .required = true,
                   .meaning = "Group of the mesh whose elements these are.",
                   .binding = field<region_of, &sim::MaterialSpec::group>});
  table.push_back({.path = "body[].region[].material", .kind = Kind::table, .meaning = "Material of that part."});
  std::vector<Key> part =
      constants<region_of>({"body[].region[].material.model", "body[].region[].material.young",
                            "body[].region[].material.poisson", "body[].region[].material.density"});
  for (Key& key : part) key.absent = "as the body";
  append(table, part);
  return table;
}

}  // namespace app
