#include "app/mesh/abaqus_types.h"

#include <array>

namespace app {
namespace {

struct AbaqusType {
  std::string_view names;  // without the letters behind the number of nodes (R, H, I, M, ...), a blank behind each
  int type;                // Gmsh's number
};
// Abaqus Analysis User's Guide, volume IV: elements. CalculiX CrunchiX User's Manual, 6.2.
constexpr std::array<AbaqusType, 13> abaqus_types = {{{"C3D4 DC3D4 AC3D4 ", 4},
                                                      {"C3D5 ", 7},
                                                      {"C3D6 ", 6},
                                                      {"C3D8 DC3D8 AC3D8 ", 5},
                                                      {"C3D10 DC3D10 AC3D10 ", 11},
                                                      {"C3D15 ", 18},
                                                      {"C3D20 DC3D20 ", 17},
                                                      {"S3 STRI3 M3D3 SFM3D3 CPS3 CPE3 DS3 R3D3 ", 2},
                                                      {"S4 S4R5 M3D4 SFM3D4 CPS4 CPE4 DS4 R3D4 ", 3},
                                                      {"S6 STRI65 M3D6 SFM3D6 CPS6 CPE6 ", 9},
                                                      {"S8 S8R5 M3D8 SFM3D8 CPS8 CPE8 ", 16},
                                                      {"T2D2 T3D2 B21 B31 ", 1},
                                                      {"T2D3 T3D3 ", 8}}};

struct AbaqusFace {
  int type, face;
  std::array<int, 6> nodes;  // -1: no more
};
// Abaqus Analysis User's Guide, 28.1: element faces, nodes counted from 0. Middles of the edges of a tet: 01 12 20 03
// 13 23 are nodes 4 to 9.
constexpr std::array<AbaqusFace, 21> abaqus_faces = {
    {{4, 1, {0, 1, 2, -1, -1, -1}},  {4, 2, {0, 3, 1, -1, -1, -1}},  {4, 3, {1, 3, 2, -1, -1, -1}},
     {4, 4, {2, 3, 0, -1, -1, -1}},  {11, 1, {0, 1, 2, 4, 5, 6}},    {11, 2, {0, 3, 1, 7, 8, 4}},
     {11, 3, {1, 3, 2, 8, 9, 5}},    {11, 4, {2, 3, 0, 9, 7, 6}},    {5, 1, {0, 1, 2, 3, -1, -1}},
     {5, 2, {4, 7, 6, 5, -1, -1}},   {5, 3, {0, 4, 5, 1, -1, -1}},   {5, 4, {1, 5, 6, 2, -1, -1}},
     {5, 5, {2, 6, 7, 3, -1, -1}},   {5, 6, {3, 7, 4, 0, -1, -1}},   {2, 1, {0, 1, -1, -1, -1, -1}},
     {2, 2, {1, 2, -1, -1, -1, -1}}, {2, 3, {2, 0, -1, -1, -1, -1}}, {3, 1, {0, 1, -1, -1, -1, -1}},
     {3, 2, {1, 2, -1, -1, -1, -1}}, {3, 3, {2, 3, -1, -1, -1, -1}}, {3, 4, {3, 0, -1, -1, -1, -1}}}};

}  // namespace

const MshType* find_abaqus_type(std::string_view name) {
  const auto find = [](std::string_view wanted) -> const MshType* {
    for (const AbaqusType& type : abaqus_types) {
      if ((" " + std::string(type.names)).find(" " + std::string(wanted) + " ") != std::string::npos)
        return find_msh_type(type.type);
    }
    return nullptr;
  };
  if (const MshType* type = find(name)) return type;
  const std::size_t digit = name.find_last_of("0123456789");
  return digit == name.npos ? nullptr : find(name.substr(0, digit + 1));
}

std::vector<int> abaqus_face(const MshType& type, int face) {
  for (const AbaqusFace& entry : abaqus_faces) {
    if (entry.type != type.number || entry.face != face) continue;
    std::vector<int> nodes;
    for (const int node : entry.nodes) {
      if (node >= 0) nodes.push_back(node);
    }
    return nodes;
  }
  return {};
}

}  // namespace app
