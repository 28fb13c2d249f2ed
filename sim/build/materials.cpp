#include "sim/build/materials.h"

#include "sim/build/key_path.h"
#include "sim/mesh/locate.h"

namespace sim {

std::vector<int> material_of_elements(const Body& body, std::size_t number) {
  std::vector<int> of(body.mesh.element_count(), 0);
  for (std::size_t m = 1; m < body.materials.size(); ++m) {
    const std::string key = key_of("body", number) + "." + key_of("region", m - 1);
    const Group group =
        below(key, [&] { return find_group(body.mesh, {body.materials[m].group}, GroupPart::elements); });
    if (group.elements.empty()) throw InputError(key + ".group", "group \"" + group.name + "\" has no elements");
    for (const int e : group.elements) of[e] = static_cast<int>(m);
  }
  return of;
}

}  // namespace sim
