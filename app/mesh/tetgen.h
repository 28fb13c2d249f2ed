// Meshes of TetGen: NAME.node has the points, NAME.ele the tets (or, by Triangle, the triangles in the plane),
// NAME.face the marked faces of tets.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/mesh.h"

namespace app {

// A whole file, with its name for messages.
struct NamedContent {
  std::string_view content, name;
};

// Points are numbered from 0 or from 1: the first one tells. The first attribute of elements and the markers of points
// and faces become groups by their number; a marker 0 means none. face may be empty. Throws FileError.
sim::Mesh read_tetgen(NamedContent node, NamedContent ele, NamedContent face, std::vector<std::string>& remarks);

// content: of the .node or the .ele file that `name` says; the others are read from beside it.
sim::Mesh read_tetgen(std::string_view content, std::string_view name, std::vector<std::string>& remarks);

}  // namespace app
