// The keys that say where: a box, a sphere or a group of the mesh.
#pragma once

#include "app/scene/keys/binding.h"

namespace app {

// `path` and `meaning` hold box, sphere and group in this order; `where` is the sim::Region member of the owner.
template <auto owner, auto where>
std::vector<Key> where_keys(const std::array<std::string_view, 3>& path,
                            const std::array<std::string_view, 3>& meaning) {
  return {
      {.path = path[0],
       .kind = Kind::box,
       .unit = "m",
       .absent = "sphere or group",
       .meaning = meaning[0],
       .binding = alternative<owner, where, sim::Box>},
      {.path = path[1],
       .kind = Kind::ball,
       .unit = "m",
       .absent = "box or group",
       .meaning = meaning[1],
       .binding = alternative<owner, where, sim::Sphere>},
      {.path = path[2],
       .kind = Kind::text,
       .absent = "box or sphere",
       .meaning = meaning[2],
       .binding = alternative<owner, where, sim::InGroup>},
  };
}

}  // namespace app
