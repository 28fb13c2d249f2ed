#include "app/mesh/tetgen.h"

#include <filesystem>

#include "app/mesh/contents.h"
#include "app/mesh/msh_contents.h"
#include "app/mesh/msh_mesh.h"

namespace app {
namespace {

constexpr int triangle = 2, tet = 4, marked_point = 15;  // Gmsh's numbers

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

class TetgenReader {
 public:
  // Points, dimension, attributes, markers; then number, x, y (, z), attributes, marker of each.
  void read_points(Cursor& in) {
    const int count = read_first_count(in, "the number of points", 6);
    dimension_ = static_cast<int>(in.integer("the dimension", 2, 3));
    const std::int64_t attributes = in.line_finished() ? 0 : in.integer("the number of attributes", 0, 1000);
    const bool marked = !in.line_finished() && in.integer("the number of markers", 0, 1) == 1;
    in.rest_of_line();
    std::vector<std::string_view> markers;
    for (int i = 0; i < count; ++i) {
      expect_number(in, i, first_, "the number of a point");
      for (int axis = 0; axis < dimension_; ++axis) {
        if (in.line_finished()) in.fail("a point needs " + std::to_string(dimension_) + " coordinates");
        contents_.coordinates.push_back(in.real("a coordinate"));
      }
      if (dimension_ == 2) contents_.coordinates.push_back(0);
      for (std::int64_t k = 0; k < attributes && !in.line_finished(); ++k) in.word("an attribute");
      markers.push_back(marked && !in.line_finished() ? in.word("a marker") : "0");
      in.rest_of_line();
    }
    number_nodes_from(in, first_, contents_);
    for (int i = 0; i < count; ++i) {
      const std::vector<int> groups = marker_group(0, markers[static_cast<std::size_t>(i)]);
      if (!groups.empty()) add_element(in, *find_msh_type(marked_point), groups, {first_ + i}, contents_);
    }
  }

  // Elements, nodes of each, attributes; then number, nodes, attributes of each, of which the first is its region.
  void read_elements(Cursor& in) {
    const int corners = dimension_ + 1;
    const int count = read_first_count(in, "the number of elements", 2 + 2 * static_cast<std::size_t>(corners));
    const std::int64_t nodes = in.line_finished() ? corners : in.integer("the number of nodes per element", 3, 10);
    if (nodes != corners) {
      in.fail("elements have " + std::to_string(nodes) + " nodes; " + std::to_string(corners) +
              " are read (write the mesh without option -o2; the scene's key element raises the order)");
    }
    in.rest_of_line();
    std::int64_t first = 0;
    for (int i = 0; i < count; ++i) {
      expect_number(in, i, first, "the number of an element");
      const std::vector<std::int64_t> tags = read_nodes(in, corners, "an element");
      std::vector<int> groups;
      if (!in.line_finished()) groups.push_back(contents_.tag_of(dimension_, std::string(in.word("an attribute"))));
      add_element(in, *find_msh_type(dimension_ == 2 ? triangle : tet), groups, tags, contents_);
      in.rest_of_line();
    }
  }

  // Faces, markers; then number, corners, marker of each.
  void read_faces(Cursor& in) {
    const int count = in.checked_count(in.whole("the number of faces"), 6, "the number of faces");
    in.rest_of_line();
    for (int i = 0; i < count; ++i) {
      in.whole("the number of a face");
      const std::vector<std::int64_t> tags = read_nodes(in, 3, "a face");
      if (in.line_finished()) continue;
      const std::vector<int> groups = marker_group(2, in.word("a marker"));
      if (!groups.empty()) add_element(in, *find_msh_type(triangle), groups, tags, contents_);
      in.rest_of_line();
    }
  }

  MshContents& contents() { return contents_; }

 private:
  std::vector<std::int64_t> read_nodes(Cursor& in, int count, const std::string& what) {
    std::vector<std::int64_t> tags;
    const auto points = static_cast<std::int64_t>(contents_.coordinates.size() / 3);
    for (int corner = 0; corner < count; ++corner) {
      if (in.line_finished()) in.fail(what + " needs " + std::to_string(count) + " nodes");
      tags.push_back(in.integer("a node", first_, first_ + points - 1));
    }
    return tags;
  }

  std::vector<int> marker_group(int dimension, std::string_view marker) {
    if (marker == "0") return {};
    return {contents_.tag_of(dimension, std::string(marker))};
  }

  MshContents contents_;
  int dimension_ = 3;
  std::int64_t first_ = 0;  // number of the first point
};

}  // namespace

sim::Mesh read_tetgen(NamedContent node, NamedContent ele, NamedContent face, std::vector<std::string>& remarks) {
  TetgenReader reader;
  Cursor node_file(node.content, node.name, '#'), ele_file(ele.content, ele.name, '#');
  Cursor face_file(face.content, face.name, '#');
  reader.read_points(node_file);
  reader.read_elements(ele_file);
  if (!face_file.finished()) reader.read_faces(face_file);
  return make_mesh(reader.contents(), std::string(node.name), remarks);
}

sim::Mesh read_tetgen(std::string_view content, std::string_view name, std::vector<std::string>& remarks) {
  const auto beside = [&](const char* ending) { return std::filesystem::path(name).replace_extension(ending); };
  const bool is_node = std::filesystem::path(name).extension().string().find_first_of("eE") != 1;
  const std::filesystem::path sibling = beside(is_node ? ".ele" : ".node"), face = beside(".face");
  const std::string other = read_contents(sibling), sibling_name = sibling.string(), face_name = face.string();
  const std::string faces = std::filesystem::exists(face) ? read_contents(face) : std::string();
  const NamedContent own = {content, name}, its = {other, sibling_name};
  return read_tetgen(is_node ? own : its, is_node ? its : own, {faces, face_name}, remarks);
}

}  // namespace app
