#include "app/mesh/msh_type.h"

#include <array>

namespace app {
namespace {

using Kind = sim::ElementKind;

// Gmsh reference manual, "MSH file format": element types 1 to 19.
constexpr std::array<MshType, 19> types = {{{1, "line2", 1, 2, std::nullopt},
                                            {2, "tri3", 2, 3, Kind::tri3},
                                            {3, "quad4", 2, 4, Kind::quad4},
                                            {4, "tet4", 3, 4, Kind::tet4},
                                            {5, "hex8", 3, 8, Kind::hex8},
                                            {6, "prism6", 3, 6, std::nullopt},
                                            {7, "pyramid5", 3, 5, std::nullopt},
                                            {8, "line3", 1, 3, std::nullopt},
                                            {9, "tri6", 2, 6, Kind::tri6},
                                            {10, "quad9", 2, 9, std::nullopt},
                                            {11, "tet10", 3, 10, Kind::tet10},
                                            {12, "hex27", 3, 27, std::nullopt},
                                            {13, "prism18", 3, 18, std::nullopt},
                                            {14, "pyramid14", 3, 14, std::nullopt},
                                            {15, "point", 0, 1, std::nullopt},
                                            {16, "quad8", 2, 8, std::nullopt},
                                            {17, "hex20", 3, 20, std::nullopt},
                                            {18, "prism15", 3, 15, std::nullopt},
                                            {19, "pyramid13", 3, 13, std::nullopt}}};

}  // namespace

const MshType* find_msh_type(std::int64_t number) {
  for (const MshType& type : types) {
    if (type.number == number) return &type;
  }
  return nullptr;
}

}  // namespace app
