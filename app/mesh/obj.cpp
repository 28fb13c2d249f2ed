#include "app/mesh/obj.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "app/mesh/cursor.h"
#include "app/mesh/mesh_nodes.h"

namespace app {
namespace {

struct Surface {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<int> triangles;  // three vertices each
  std::size_t polygons = 0;    // faces of more than three corners
};

// "v x y z", with a weight or a colour behind it perhaps.
Eigen::Vector3d read_vertex(Cursor& in) {
  Eigen::Vector3d X;
  for (double& x : X) {
    if (in.line_finished()) in.fail("a vertex needs three coordinates");
    x = in.real("a coordinate");
  }
  return X;
}

// "7", "7/1", "7/1/3" or "7//3": the vertex comes first, counted from 1, or from the last one backwards (-1).
int read_corner(Cursor& in, int vertex_count) {
  const std::string_view word = in.word("a corner of a face");
  std::int64_t vertex = 0;
  if (!parse(word.substr(0, word.find('/')), vertex) || vertex == 0) {
    in.fail("a corner of a face is " + quote(word) + "; it should be the number of a vertex, such as 7 or 7/1/3");
  }
  if (vertex > vertex_count || vertex < -vertex_count) {
    in.fail("a face refers to vertex " + std::to_string(vertex) + "; the number of vertices above it is " +
            std::to_string(vertex_count));
  }
  return static_cast<int>(vertex > 0 ? vertex - 1 : vertex + vertex_count);
}

// A fan of triangles covers a polygon once if all of them turn the way that the polygon does: 2 A = sum of their
// cross products is the polygon's area vector.
bool fan_covers(const Surface& surface, const std::vector<int>& corners) {
  const auto X = [&](std::size_t i) { return surface.vertices[static_cast<std::size_t>(corners[i])]; };
  std::vector<Eigen::Vector3d> areas;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i) {
    areas.push_back((X(i - 1) - X(0)).cross(X(i) - X(0)));
    sum += areas.back();
  }
  return std::all_of(areas.begin(), areas.end(), [&](const Eigen::Vector3d& area) { return area.dot(sum) > 0; });
}

void read_face(Cursor& in, Surface& surface) {
  std::vector<int> corners;
  while (!in.line_finished()) {
    corners.push_back(read_corner(in, static_cast<int>(surface.vertices.size())));
  }
  std::vector<int> sorted = corners;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) in.fail("vertex " + std::to_string(*twice + 1) + " stands twice in one face");
  if (corners.size() < 3) in.fail("a face has " + std::to_string(corners.size()) + " corners; it needs three or more");
  if (corners.size() > 3) {
    ++surface.polygons;
    if (!fan_covers(surface, corners)) {
      in.fail("a face of " + std::to_string(corners.size()) + " corners is not convex: cut it into triangles");
    }
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    surface.triangles.insert(surface.triangles.end(), {corners[0], corners[i - 1], corners[i]});
  }
}

Surface read_surface(Cursor& in) {
  Surface surface;
  while (!in.finished()) {
    const std::string_view statement = in.word("a statement");
    if (statement == "v") {
      surface.vertices.push_back(read_vertex(in));
    } else if (statement == "f") {
      read_face(in, surface);
    }
    in.rest_of_line();
  }
  if (surface.triangles.empty()) {
    in.fail("the file ends without a face (f); number of vertices: " + std::to_string(surface.vertices.size()));
  }
  return surface;
}

}  // namespace

sim::Mesh read_obj(std::string_view content, std::string_view name, std::vector<std::string>& remarks) {
  Cursor in(content, name, '#');
  const Surface surface = read_surface(in);
  sim::Mesh mesh;
  mesh.kind = sim::ElementKind::tri3;
  mesh.X.resize(3, static_cast<Eigen::Index>(surface.vertices.size()));
  for (std::size_t i = 0; i < surface.vertices.size(); ++i)
    mesh.X.col(static_cast<Eigen::Index>(i)) = surface.vertices[i];
  mesh.elements = Eigen::Map<const Eigen::MatrixXi>(surface.triangles.data(), 3,
                                                    static_cast<Eigen::Index>(surface.triangles.size() / 3));
  if (surface.polygons > 0) {
    remarks.push_back(std::string(name) +
                      ": faces of more than three corners, cut into triangles: " + std::to_string(surface.polygons));
  }
  keep_used_nodes(mesh, name, remarks);
  flatten(mesh, name);
  return mesh;
}

}  // namespace app
