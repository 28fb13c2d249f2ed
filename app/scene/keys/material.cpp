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
      {path[0], Form(Kind::choice).of(material_names), field<owner, &sim::MaterialSpec::model>,
       "Energy density of the material."},
      {path[1], Form(Kind::number, "Pa", above(0)), field<owner, &sim::MaterialSpec::young>,
       "Young's modulus: stiffness. Jelly 1e4, rubber 1e6, wood 1e10, steel 2e11."},
      {path[2], Form(Kind::number, "", inside(-1, 0.5)), field<owner, &sim::MaterialSpec::poisson>,
       "Poisson's ratio: how much it thins when stretched; close to 0.5 it keeps its volume."},
      {path[3], Form(Kind::number, "kg/m^3", above(0)), field<owner, &sim::MaterialSpec::density>,
       "Mass per volume at rest."},
  };
}

}  // namespace

std::vector<Key> material_keys() {
  std::vector<Key> table = {{"body[].material", Kind::table, {}, "Material of the body."}};
  std::vector<Key> whole = constants<material_of>(
      {"body[].material.model", "body[].material.young", "body[].material.poisson", "body[].material.density"});
  append(table, whole);

  table.push_back({"body[].region[]", Kind::list, regions, "A part of the body with a material of its own."});
  table.push_back({"body[].region[].group", Form(Kind::text).tells(Effect::restart).needed(),
                   field<region_of, &sim::MaterialSpec::group>, "Group of the mesh whose elements these are."});
  table.push_back({"body[].region[].material", Kind::table, {}, "Material of that part."});
  std::vector<Key> part =
      constants<region_of>({"body[].region[].material.model", "body[].region[].material.young",
                            "body[].region[].material.poisson", "body[].region[].material.density"});
  for (Key& key : part) key.absent = "as the body";
  append(table, part);
  return table;
}

}  // namespace app
