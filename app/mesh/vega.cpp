#include "app/mesh/vega.h"

#include <map>
#include <set>

#include "app/mesh/msh_contents.h"
#include "app/mesh/msh_mesh.h"

namespace app {
namespace {

constexpr int vega_tet = 4, vega_cube = 5;  // Gmsh's numbers

// Sections start with *NAME. Vertices come before elements, sets of elements after them.
class VegaReader {
 public:
  explicit VegaReader(Cursor& in) : in_(in) {}

  MshContents read() {
    while (!in_.finished()) {
      const std::string_view section = in_.word("a section");
      if (section == "*VERTICES") {
        read_vertices();
      } else if (section == "*ELEMENTS") {
        read_elements();
      } else if (section == "*SET") {
        read_set();
      } else if (section == "*INCLUDE") {
        in_.fail("*INCLUDE is not read: put the file's lines in its place");
      } else if (section.starts_with('*')) {
        pass_over();
      } else {
        in_.fail(quote(section) + " stands where a section such as *VERTICES should begin");
      }
    }
    if (elements_.empty()) in_.fail("the file ends without *ELEMENTS");
    put_elements();
    return std::move(contents_);
  }

 private:
  bool section_finished() { return in_.finished() || in_.peek() == '*'; }

  void pass_over() {
    in_.rest_of_line();
    while (!section_finished()) in_.rest_of_line();
  }

  // How many, the dimension 3, attributes 0 0; then number and coordinates of each.
  void read_vertices() {
    if (!contents_.coordinates.empty()) in_.fail("a second section *VERTICES; there should be one");
    const int count = in_.checked_count(in_.whole("the number of vertices"), 8, "the number of vertices");
    in_.integer("the dimension", 3, 3);
    in_.rest_of_line();
    std::vector<std::int64_t> tags;
    for (int i = 0; i < count; ++i) {
      tags.push_back(in_.whole("the number of a vertex"));
      for (int axis = 0; axis < 3; ++axis) contents_.coordinates.push_back(in_.real("a coordinate"));
    }
    number_nodes(in_, tags, contents_);
  }

  // TET or CUBIC; how many, nodes of each, attributes; then number and nodes of each.
  void read_elements() {
    if (!elements_.empty()) in_.fail("a second section *ELEMENTS; there should be one");
    const std::string_view kind = in_.word("the kind of the elements");
    if (kind != "TET" && kind != "TETS" && kind != "CUBIC") {
      in_.fail("the elements are " + quote(kind) + "; they should be TET or CUBIC");
    }
    type_ = find_msh_type(kind == "CUBIC" ? vega_cube : vega_tet);
    const auto nodes = static_cast<std::size_t>(type_->nodes);
    const int count = in_.checked_count(in_.whole("the number of elements"), 2 + 2 * nodes, "the number of elements");
    in_.integer("the number of nodes per element", type_->nodes, type_->nodes);
    in_.rest_of_line();
    for (int i = 0; i < count; ++i) {
      VegaElement element{in_.whole("the number of an element"), {}, {}, in_.position()};
      for (std::size_t k = 0; k < nodes; ++k) element.nodes.push_back(in_.whole("a node of an element"));
      numbers_[element.number] = elements_.size();
      elements_.push_back(std::move(element));
    }
  }

  // A name; then numbers of elements, with commas between them.
  void read_set() {
    const std::string set(in_.word("the name of a set"));
    const int tag = contents_.tag_of(3, set);
    while (!section_finished()) {
      const std::int64_t number = in_.whole("an element of a set");
      const auto found = numbers_.find(number);
      if (found == numbers_.end())
        in_.fail("the set " + quote(set) + " names element " + std::to_string(number) +
                 ", which is not among the elements");
      elements_[found->second].groups.insert(tag);
    }
  }

  void put_elements() {
    for (const VegaElement& element : elements_) {
      in_.go_to(element.place);
      in_.word("a node of an element");  // errors point at it
      add_element(in_, *type_, {element.groups.begin(), element.groups.end()}, element.nodes, contents_);
    }
  }

  struct VegaElement {
    std::int64_t number;
    std::vector<std::int64_t> nodes;
    std::set<int> groups;  // tags
    std::size_t place;     // in the file
  };

  Cursor& in_;
  MshContents contents_;
  const MshType* type_ = nullptr;
  std::vector<VegaElement> elements_;
  std::map<std::int64_t, std::size_t> numbers_;
};

}  // namespace

sim::Mesh read_vega(std::string_view content, std::string_view name, std::vector<std::string>& remarks) {
  Cursor in(content, name, '#', ',');
  return make_mesh(VegaReader(in).read(), std::string(name), remarks);
}

}  // namespace app
