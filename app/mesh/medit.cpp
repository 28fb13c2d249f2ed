#include "app/mesh/medit.h"

#include <array>

#include "app/mesh/msh_contents.h"
#include "app/mesh/msh_mesh.h"

namespace app {
namespace {

// [Frey 2001, MEDIT: an interactive mesh visualization software, INRIA RT-0253] and the P2 kinds of its successors, in
// whose tets the middles of edges follow 01 12 20 03 13 23: Gmsh has the last two the other way round.
struct MeditSection {
  std::string_view keyword;
  int type;  // Gmsh's number
};
constexpr std::array<MeditSection, 8> medit_sections = {{{"Edges", 1},
                                                         {"EdgesP2", 8},
                                                         {"Triangles", 2},
                                                         {"Quadrilaterals", 3},
                                                         {"Tetrahedra", 4},
                                                         {"Hexahedra", 5},
                                                         {"TrianglesP2", 9},
                                                         {"TetrahedraP2", 11}}};
constexpr int medit_p2_tet = 11;

class MeditReader {
 public:
  explicit MeditReader(Cursor& in) : in_(in) {}

  MshContents read() {
    in_.expect("MeshVersionFormatted");
    in_.integer("the version", 0, 4);
    while (!in_.finished()) {
      const std::string_view keyword = in_.word("a keyword");
      if (keyword == "End") break;
      if (keyword == "Dimension") {
        dimension_ = static_cast<int>(in_.integer("the dimension", 2, 3));
      } else if (keyword == "Vertices") {
        read_vertices();
      } else {
        read_section(keyword);
      }
    }
    if (contents_.coordinates.empty()) in_.fail("the file ends without Vertices");
    for (const auto& [type, place] : early_) {
      in_.go_to(place);
      read_elements(*type);
    }
    return std::move(contents_);
  }

 private:
  // Number; then coordinates and reference of each.
  void read_vertices() {
    if (dimension_ == 0) in_.fail("Vertices stand before Dimension; they should follow");
    if (!contents_.coordinates.empty()) in_.fail("a second section Vertices; there should be one");
    const int count = in_.checked_count(in_.whole("the number of vertices"), 6, "the number of vertices");
    std::vector<std::int64_t> references;
    for (int i = 0; i < count; ++i) {
      for (int axis = 0; axis < 3; ++axis)
        contents_.coordinates.push_back(axis < dimension_ ? in_.real("a coordinate") : 0.0);
      references.push_back(in_.whole("a reference"));
    }
    number_nodes_from(in_, 1, contents_);
    for (int i = 0; i < count; ++i) {
      if (references[static_cast<std::size_t>(i)] == 0) continue;
      add_element(in_, *find_msh_type(15), group(0, references[static_cast<std::size_t>(i)]), {i + 1}, contents_);
    }
  }

  std::vector<int> group(int dimension, std::int64_t reference) {
    if (reference == 0) return {};
    return {contents_.tag_of(dimension, std::to_string(reference))};
  }

  void read_section(std::string_view keyword) {
    for (const MeditSection& section : medit_sections) {
      if (section.keyword == keyword) return read_elements(*find_msh_type(section.type));
    }
    std::int64_t number = 0;
    double real = 0;
    if (parse(keyword, number) || parse(keyword, real)) {
      in_.fail(quote(keyword) + " stands where a keyword such as Tetrahedra should be");
    }
    pass_over();
  }

  // What is not known ends where the next word begins that is no number.
  void pass_over() {
    while (!in_.finished()) {
      const std::size_t start = in_.position();
      double number = 0;
      if (parse(in_.word("a number"), number)) continue;
      return in_.go_to(start);
    }
  }

  // Number; then nodes and reference of each.
  void read_elements(const MshType& type) {
    if (contents_.coordinates.empty()) {
      early_.emplace_back(&type, in_.position());
      return pass_over();
    }
    const std::size_t bytes = 2 * (static_cast<std::size_t>(type.nodes) + 1);
    const int count = in_.checked_count(in_.whole("the number of elements"), bytes, "the number of elements");
    std::vector<std::int64_t> nodes(static_cast<std::size_t>(type.nodes));
    for (int i = 0; i < count; ++i) {
      for (std::int64_t& node : nodes) node = in_.whole("a node of an element");
      if (type.number == medit_p2_tet) std::swap(nodes[8], nodes[9]);
      const std::vector<int> physical = group(type.dimension, in_.whole("a reference"));
      add_element(in_, type, physical, nodes, contents_);
    }
  }

  Cursor& in_;
  int dimension_ = 0;
  std::vector<std::pair<const MshType*, std::size_t>> early_;  // elements that stand before the vertices, and where
  MshContents contents_;
};

}  // namespace

sim::Mesh read_medit(std::string_view content, std::string_view name, std::vector<std::string>& remarks) {
  Cursor in(content, name, '#');
  return make_mesh(MeditReader(in).read(), std::string(name), remarks);
}

}  // namespace app
