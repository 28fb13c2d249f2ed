// One input of the fuzzer for mesh files, and what must hold for whatever it is: a mesh that is whole, or a FileError.
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "app/mesh/error.h"
#include "app/mesh/mesh_file.h"
#include "app/mesh/tetgen.h"
#include "sim/mesh/mesh.h"

namespace app {

inline bool in_range(const Eigen::MatrixXi& indices, int count) {
  return indices.size() == 0 || (indices.minCoeff() >= 0 && indices.maxCoeff() < count);
}

inline bool in_range(const std::vector<int>& indices, int count) {
  for (const int i : indices) {
    if (i < 0 || i >= count) return false;
  }
  return true;
}

// Finite coordinates, no index out of range, no node without an element.
inline bool is_whole(const sim::Mesh& mesh) {
  if (mesh.element_count() == 0 || !mesh.X.allFinite() || !in_range(mesh.elements, mesh.node_count())) return false;
  for (const sim::Group& group : mesh.groups) {
    if (!in_range(group.nodes, mesh.node_count()) || !in_range(group.elements, mesh.element_count()) ||
        !in_range(group.facets, mesh.node_count())) {
      return false;
    }
  }
  std::vector<bool> used(static_cast<std::size_t>(mesh.node_count()));
  for (const int node : mesh.elements.reshaped()) used[static_cast<std::size_t>(node)] = true;
  return std::find(used.begin(), used.end(), false) == used.end();
}

// The format is told by how an input begins; TetGen's two files are joined by the first %, STL has a mark of its own in
// front, all else is Wavefront.
inline sim::Mesh read_any(std::string_view input, std::vector<std::string>& remarks) {
  constexpr std::array<std::pair<std::string_view, const char*>, 9> beginnings = {{{"$", "fuzz.msh"},
                                                                                   {"# vtk", "fuzz.vtk"},
                                                                                   {"<", "fuzz.vtu"},
                                                                                   {"MeshVersion", "fuzz.mesh"},
                                                                                   {"*VERTICES", "fuzz.veg"},
                                                                                   {"*", "fuzz.inp"},
                                                                                   {"ply", "fuzz.ply"},
                                                                                   {"OFF", "fuzz.off"},
                                                                                   {"stl:", "fuzz.stl"}}};
  for (const auto& [beginning, name] : beginnings) {
    if (!input.starts_with(beginning)) continue;
    return read_mesh(beginning == "stl:" ? input.substr(4) : input, name, remarks);
  }
  const std::size_t joint = input.find('%');
  if (joint == input.npos) return read_mesh(input, "fuzz.obj", remarks);
  return read_tetgen({input.substr(0, joint), "fuzz.node"}, {input.substr(joint + 1), "fuzz.ele"}, {"", "fuzz.face"},
                     remarks);
}

// True when a mesh was read, false when the input was refused. Aborts on a mesh that is not whole.
inline bool try_mesh_input(std::string_view input) {
  std::vector<std::string> remarks;
  try {
    if (!is_whole(read_any(input, remarks))) std::abort();
    return true;
  } catch (const FileError&) {
    return false;
  }
}

}  // namespace app
