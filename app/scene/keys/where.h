// The keys that say where: a box, a sphere or a group of the mesh.
#pragma once

#include "app/scene/keys/binding.h"

namespace app {

// `path` and `meaning` hold box, sphere and group in this order; `where` is the sim::Region member of the owner.
template <auto owner, auto where>
std::vector<Key> where_keys(const std::array<std::string_view, 3>& path,
                            const std::array<std::string_view, 3>& meaning) {
  return {
      {path[0], Form(Kind::box, "m").otherwise("sphere or group"), alternative<owner, where, sim::Box>, meaning[0]},
      {path[1], Form(Kind::ball, "m").otherwise("box or group"), alternative<owner, where, sim::Sphere>, meaning[1]},
      {path[2], Form(Kind::text).otherwise("box or sphere"), alternative<owner, where, sim::InGroup>, meaning[2]},
  };
}

}  // namespace app
