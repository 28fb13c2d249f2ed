#include "app/mesh/tetgen.h"

#include "app/mesh/cursor.h"
#include "app/mesh/mesh_nodes.h"

namespace app {
namespace {

struct Points {
  Eigen::MatrixXd X;       // dimension x points
  std::int64_t first = 0;  // number of the first point
};

// Points and elements are numbered without gaps from the number of the first.
void expect_number(Cursor& in, int index, std::int64_t& first, std::string_view what) {
  if (index == 0) {
    first = in.integer(what, 0, 1);
  } else {
    in.integer(what, first + index, first + index);
  }
}

int read_first_count(Cursor& in, std::string_view what, std::size_t bytes_each) {
  const int count = in.checked_count(in.whole(what), bytes_each, what);
  if (count == 0) in.fail(std::string(what) + " is 0; a mesh has at least one");
  return count;
}

// Points, dimension, attributes, markers; then number, x, y (, z), attributes, marker of each.
Points read_points(Cursor& in) {
  const int count = read_first_count(in, "the number of points", 6);
  const auto dimension = static_cast<int>(in.integer("the dimension", 2, 3));
  in.rest_of_line();
  Points points;
  points.X.resize(dimension, count);
  for (int i = 0; i < count; ++i) {
    expect_number(in, i, points.first, "the number of a point");
    for (int axis = 0; axis < dimension; ++axis) {
      if (in.line_finished()) in.fail("a point needs " + std::to_string(dimension) + " coordinates");
      points.X(axis, i) = in.real("a coordinate");
    }
    in.rest_of_line();
  }
  return points;
}

// Elements, nodes of each, attributes; then number, nodes, attribute of each.
Eigen::MatrixXi read_elements(Cursor& in, const Points& points) {
  const int corners = static_cast<int>(points.X.rows()) + 1;
  const int count = read_first_count(in, "the number of elements", 2 + 2 * static_cast<std::size_t>(corners));
  const std::int64_t nodes = in.line_finished() ? corners : in.integer("the number of nodes per element", 3, 10);
  if (nodes != corners) {
    in.fail("elements have " + std::to_string(nodes) + " nodes; " + std::to_string(corners) +
            " are read (write the mesh without option -o2; the scene's key element raises the order)");
  }
  in.rest_of_line();
  Eigen::MatrixXi elements(corners, count);
  std::int64_t first = 0;
  for (int i = 0; i < count; ++i) {
    expect_number(in, i, first, "the number of an element");
    for (int corner = 0; corner < corners; ++corner) {
      if (in.line_finished()) in.fail("an element needs " + std::to_string(corners) + " nodes");
      const std::int64_t node = in.integer("a node", points.first, points.first + points.X.cols() - 1);
      elements(corner, i) = static_cast<int>(node - points.first);
      if ((elements.col(i).head(corner).array() == elements(corner, i)).any()) {
        in.fail("node " + std::to_string(node) + " stands twice in one element");
      }
    }
    in.rest_of_line();
  }
  return elements;
}

}  // namespace

sim::Mesh read_tetgen(std::string_view node_content, std::string_view node_name, std::string_view ele_content,
                      std::string_view ele_name, std::vector<std::string>& remarks) {
  Cursor node_file(node_content, node_name, '#'), ele_file(ele_content, ele_name, '#');
  const Points points = read_points(node_file);
  sim::Mesh mesh;
  mesh.kind = points.X.rows() == 2 ? sim::ElementKind::tri3 : sim::ElementKind::tet4;
  mesh.X = points.X;
  mesh.elements = read_elements(ele_file, points);
  keep_used_nodes(mesh, node_name, remarks);
  return mesh;
}

}  // namespace app
