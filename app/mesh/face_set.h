// The faces of a surface file, as its reader meets them, and the mesh of triangles that they make.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/mesh/cursor.h"
#include "sim/mesh/mesh.h"

namespace app {

class FaceSet {
 public:
  // first: the number of the first vertex in this format, for messages.
  explicit FaceSet(int first) : first_(first) {}

  std::vector<Eigen::Vector3d> vertices;  // m

  // A face that was just read, by indices of vertices that exist: cut into triangles where it has more corners. Fails
  // when it has fewer than three, one twice, or sides that cross each other.
  void add(const Cursor& in, const std::vector<int>& corners);
  // The faces that follow are in the groups of these names; a name may be empty, or have blanks around it.
  void put_in(const std::vector<std::string>& names);
  // Whether a vertex that a face names exists: gives back its index.
  int checked_vertex(const Cursor& in, std::int64_t index) const;

  // Faces without area are left out; vertices that stand at one place and have open edges on either side are joined,
  // which writers split where texture or normal changes; nodes of no face go. All is told in remarks. Plane when all z
  // are equal, else a membrane. Fails when there is no face.
  sim::Mesh mesh(const Cursor& in, std::vector<std::string>& remarks);

 private:
  void drop_flat(const Cursor& in, std::vector<std::string>& remarks);
  std::vector<sim::Group> groups(const sim::Mesh& mesh) const;

  int first_;
  std::vector<int> triangles_;                          // three vertices each
  std::vector<std::size_t> places_;                     // of each triangle's face in the file
  std::vector<std::size_t> part_;                       // of each triangle
  std::vector<std::vector<std::string>> parts_ = {{}};  // names of the groups of each part; the last one is filled
  std::size_t polygons_ = 0;                            // faces of more than three corners
};

}  // namespace app
