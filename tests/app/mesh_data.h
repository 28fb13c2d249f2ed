// The mesh files in tests/data and how to compare what was read from them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/mesh/mesh_file.h"
#include "tests/app/temporary_folder.h"

namespace app {

inline std::filesystem::path data_folder() {
  return std::filesystem::path(__FILE__).parent_path().parent_path() / "data";
}

// Files that Gmsh wrote: MSH 2.2 and 4.1, text and binary.
inline const std::vector<std::string> box_files = {"box-2-text.msh", "box-2-binary.msh", "box-4-text.msh",
                                                   "box-4-binary.msh"};
inline const std::vector<std::string> second_order_files = {"box-second-2-text.msh", "box-second-2-binary.msh",
                                                            "box-second-4-text.msh", "box-second-4-binary.msh"};

struct ReadMesh {
  sim::Mesh mesh;
  std::vector<std::string> remarks;
};

inline ReadMesh read_data(const std::string& file) {
  ReadMesh result;
  result.mesh = read_mesh(data_folder() / file, result.remarks);
  return result;
}

inline ReadMesh read_text(std::string_view content, std::string_view name) {
  ReadMesh result;
  result.mesh = read_mesh(content, name, result.remarks);
  return result;
}

inline const sim::Group& group(const sim::Mesh& mesh, const std::string& name) {
  const auto found = std::find_if(mesh.groups.begin(), mesh.groups.end(), [&](auto& g) { return g.name == name; });
  if (found == mesh.groups.end()) throw std::runtime_error("no group " + name);
  return *found;
}

inline void expect_equal(const sim::Mesh& a, const sim::Mesh& b) {
  EXPECT_EQ(a.kind, b.kind);
  ASSERT_EQ(a.X.rows(), b.X.rows());
  ASSERT_EQ(a.X.cols(), b.X.cols());
  EXPECT_LE((a.X - b.X).cwiseAbs().maxCoeff(), 1e-15);  // Gmsh writes 16 digits, one less than a double has
  EXPECT_EQ(a.elements, b.elements);
  ASSERT_EQ(a.groups.size(), b.groups.size());
  for (std::size_t i = 0; i < a.groups.size(); ++i) {
    EXPECT_EQ(a.groups[i].name, b.groups[i].name);
    EXPECT_EQ(a.groups[i].nodes, b.groups[i].nodes);
    EXPECT_EQ(a.groups[i].elements, b.groups[i].elements);
    EXPECT_EQ(a.groups[i].facets, b.groups[i].facets);
  }
}

inline std::string with_crlf(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? "\r\n" : std::string(1, c);
  return result;
}

}  // namespace app
