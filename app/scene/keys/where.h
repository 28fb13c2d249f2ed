// The keys that say where: a box, a sphere or a group of the mesh.
#pragma once

#include "app/scene/keys/binding.h"

namespace app {

// The dimension of the group in the sim::Region owner(document, indices).*where.
template <auto owner, auto where>
constexpr Binding group_dimension = {[](const Document& d, const Indices& i) -> std::optional<Value> {
                                       const auto* region = held_in(owner(d, i).*where);
                                       const auto* group = region ? std::get_if<sim::InGroup>(region) : nullptr;
                                       return group ? to_optional(group->dimension) : std::nullopt;
                                     },
                                     [](Document& d, const Indices& i, const Value& value) {
                                       auto& region = made_in(owner(d, i).*where);
                                       if (!std::holds_alternative<sim::InGroup>(region)) region = sim::InGroup{};
                                       from_value(value, std::get<sim::InGroup>(region).dimension);
                                     }};

// `path` and `meaning` hold box, sphere, group and the group's dimension in this order; `where` is the sim::Region
// member of the owner.
template <auto owner, auto where>
std::vector<Key> where_keys(const std::array<std::string_view, 4>& path,
                            const std::array<std::string_view, 4>& meaning) {
  return {
      {path[0], Form(Kind::box, "m").otherwise("sphere or group"), alternative<owner, where, sim::Box>, meaning[0]},
      {path[1], Form(Kind::ball, "m").otherwise("box or group"), alternative<owner, where, sim::Sphere>, meaning[1]},
      {path[2], Form(Kind::text).otherwise("box or sphere"), alternative<owner, where, sim::InGroup>, meaning[2]},
      {path[3], Form(Kind::integer, "", between(0, 3)).otherwise("the only one of that name"),
       group_dimension<owner, where>, meaning[3]},
  };
}

}  // namespace app
