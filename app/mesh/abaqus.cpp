#include "app/mesh/abaqus.h"

#include "app/base/text.h"
#include "app/mesh/abaqus_sets.h"
#include "app/mesh/abaqus_types.h"
#include "app/mesh/msh_contents.h"
#include "app/mesh/msh_mesh.h"

namespace app {
namespace {

constexpr int point_type = 15, tet10_type = 11;  // Gmsh's numbers

struct AbaqusElement {
  const MshType* type;
  std::vector<std::int64_t> nodes;  // tags, in Abaqus' order
  std::vector<int> groups;          // tags
  std::size_t place;                // in the file
};

class AbaqusReader {
 public:
  explicit AbaqusReader(Cursor& in) : in_(in) {}

  MshContents read(std::vector<std::string>& remarks) {
    read_cards();
    number_nodes(in_, tags_, contents_);
    for (std::size_t i = 0; i < tags_.size(); ++i) node_numbers_[tags_[i]] = i;
    for (const auto& [key, set] : element_sets_) {
      if (set.internal) continue;
      for (const AbaqusEntry& entry : set.entries) put_in_group(set.name, entry);
    }
    for (AbaqusElement& element : elements_) put(element);
    for (const auto& [key, set] : node_sets_) put_node_set(set);
    for (const auto& [key, set] : surfaces_) put_surface(set);
    for (const auto& [kind, count] : unknown_) {
      remarks.push_back(in_.name() + ": elements of type " + quote(kind) + ", left out: " + std::to_string(count));
    }
    return std::move(contents_);
  }

 private:
  void read_cards() {
    if (!abaqus_data_finished(in_)) in_.fail("the file should start with a keyword such as *NODE");
    while (!in_.finished()) {
      read_card(read_abaqus_card(in_));
      while (!abaqus_data_finished(in_)) in_.rest_of_line();  // of a keyword that is passed over
    }
    if (elements_.empty()) in_.fail("the file ends without an *ELEMENT that a body is made of");
  }

  void read_card(const AbaqusCard& card) {
    if (card.keyword == "*NODE") {
      read_nodes(card.option("NSET"));
    } else if (card.keyword == "*ELEMENT") {
      read_elements(card);
    } else if (card.keyword == "*NSET") {
      read_abaqus_set(in_, card, set_of(card, "NSET", node_sets_));
    } else if (card.keyword == "*ELSET") {
      read_abaqus_set(in_, card, set_of(card, "ELSET", element_sets_));
    } else if (card.keyword == "*SURFACE" &&
               (card.option("TYPE").empty() || in_capitals(card.option("TYPE")) == "ELEMENT")) {
      read_abaqus_surface(in_, set_of(card, "NAME", surfaces_));
    } else if (card.keyword == "*INCLUDE") {
      in_.fail("*INCLUDE is not read: put the file's lines in its place");
    } else if (card.keyword == "*PART" && parts_++ > 0) {
      in_.fail("a second *PART; one is read: write each to a file of its own, and make each a body");
    }
  }

  AbaqusSet& set_of(const AbaqusCard& card, const std::string& option, AbaqusSets& sets) {
    const std::string name = card.option(option);
    if (name.empty()) in_.fail(card.keyword + " needs a name: " + option + "=...");
    return named_set(sets, name);
  }

  // Number and up to three coordinates; those that are missing are zero.
  void read_nodes(const std::string& set) {
    while (!abaqus_data_finished(in_)) {
      AbaqusEntry entry;
      entry.place = in_.position();
      entry.first = entry.last = in_.whole("the number of a node");
      tags_.push_back(entry.first);
      for (int axis = 0; axis < 3; ++axis)
        contents_.coordinates.push_back(in_.line_finished() ? 0.0 : in_.real("a coordinate"));
      in_.rest_of_line();
      if (!set.empty()) named_set(node_sets_, set).entries.push_back(entry);
    }
  }

  // Number and nodes, on as many lines as they take.
  void read_elements(const AbaqusCard& card) {
    const std::string kind = in_capitals(card.option("TYPE"));
    if (kind.empty()) in_.fail("*ELEMENT needs a TYPE=...");
    const MshType* type = find_abaqus_type(kind);
    while (!abaqus_data_finished(in_)) {
      AbaqusEntry entry;
      entry.place = in_.position();
      entry.first = entry.last = in_.whole("the number of an element");
      if (type == nullptr) {
        ++unknown_[kind];
        in_.rest_of_line();
        continue;
      }
      AbaqusElement element{type, {}, {}, in_.position()};
      for (int i = 0; i < type->nodes; ++i) element.nodes.push_back(in_.whole("a node of an element"));
      if (!element_numbers_.try_emplace(entry.first, elements_.size()).second)
        in_.fail("a second element has the number " + std::to_string(entry.first));
      elements_.push_back(std::move(element));
      if (!card.option("ELSET").empty()) named_set(element_sets_, card.option("ELSET")).entries.push_back(entry);
    }
  }

  void put_in_group(const std::string& name, const AbaqusEntry& entry) {
    for (const std::size_t e : members(in_, element_sets_, entry, element_numbers_)) {
      std::vector<int>& groups = elements_[e].groups;
      const int tag = contents_.tag_of(elements_[e].type->dimension, name);
      if (groups.empty() || groups.back() != tag) groups.push_back(tag);
    }
  }

  void put(const AbaqusElement& element) {
    std::vector<std::int64_t> nodes = element.nodes;
    // Gmsh numbers the middles of the last two edges of a tet the other way round.
    if (element.type->number == tet10_type) std::swap(nodes[8], nodes[9]);
    in_.go_to(element.place);
    in_.word("a node of an element");  // errors point at it
    add_element(in_, *element.type, element.groups, nodes, contents_);
  }

  void put_node_set(const AbaqusSet& set) {
    if (set.internal) return;
    const int tag = contents_.tag_of(0, set.name);
    for (const AbaqusEntry& entry : set.entries) {
      for (const std::size_t i : members(in_, node_sets_, entry, node_numbers_))
        add_element(in_, *find_msh_type(point_type), {tag}, {tags_[i]}, contents_);
    }
  }

  void put_surface(const AbaqusSet& set) {
    for (const AbaqusEntry& entry : set.entries) {
      for (const std::size_t e : members(in_, element_sets_, entry, element_numbers_)) {
        const AbaqusElement& element = elements_[e];
        std::vector<std::int64_t> nodes;
        for (const int local : abaqus_face(*element.type, entry.face))
          nodes.push_back(element.nodes[static_cast<std::size_t>(local)]);
        const int type = nodes.size() == 2 ? 1 : nodes.size() == 3 ? 2 : nodes.size() == 4 ? 3 : 9;
        if (nodes.empty()) continue;
        const int tag = contents_.tag_of(element.type->dimension - 1, set.name);
        add_element(in_, *find_msh_type(type), {tag}, nodes, contents_);
      }
    }
  }

  Cursor& in_;
  MshContents contents_;
  std::vector<std::int64_t> tags_;  // of the nodes
  std::vector<AbaqusElement> elements_;
  std::map<std::int64_t, std::size_t> node_numbers_, element_numbers_;
  AbaqusSets node_sets_, element_sets_, surfaces_;
  std::map<std::string, int> unknown_;
  int parts_ = 0;
};

}  // namespace

sim::Mesh read_abaqus(std::string_view content, std::string_view name, std::vector<std::string>& remarks) {
  Cursor in(content, name, '\0', ',');
  return make_mesh(AbaqusReader(in).read(remarks), std::string(name), remarks);
}

}  // namespace app
