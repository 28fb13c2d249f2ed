#include "app/mesh/msh_type.h"

#include <algorithm>
#include <array>
#include <vector>

namespace app {
namespace {

// Gmsh reference manual, "MSH file format": of the element types 1 to 19 those which are no element of a body.
constexpr std::array<MshType, 13> others = {{{1, "line2", 1, 2, nullptr},
                                             {6, "prism6", 3, 6, nullptr},
                                             {7, "pyramid5", 3, 5, nullptr},
                                             {8, "line3", 1, 3, nullptr},
                                             {10, "quad9", 2, 9, nullptr},
                                             {12, "hex27", 3, 27, nullptr},
                                             {13, "prism18", 3, 18, nullptr},
                                             {14, "pyramid14", 3, 14, nullptr},
                                             {15, "point", 0, 1, nullptr},
                                             {16, "quad8", 2, 8, nullptr},
                                             {17, "hex20", 3, 20, nullptr},
                                             {18, "prism15", 3, 15, nullptr},
                                             {19, "pyramid13", 3, 13, nullptr}}};

std::vector<MshType> all_types() {
  std::vector<MshType> all;
  for (const sim::ElementInfo& e : sim::elements()) all.push_back({e.gmsh, e.name, e.dimension, e.nodes, &e});
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

}  // namespace

const MshType* find_msh_type(std::int64_t number) {
  static const std::vector<MshType> types = all_types();
  const auto found = std::ranges::find(types, number, &MshType::number);
  return found == types.end() ? nullptr : &*found;
}

}  // namespace app
