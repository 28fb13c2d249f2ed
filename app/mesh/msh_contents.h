// What a mesh file says, before a mesh is made of it, in Gmsh's terms: nodes, elements and physical groups. All formats
// that have elements of several kinds are put into these.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/mesh/cursor.h"
#include "app/mesh/msh_type.h"

namespace app {

// The nodes' numbers (tags) in the file, and the index of each in the order of the file.
class NodeTags {
 public:
  NodeTags() = default;
  explicit NodeTags(const std::vector<std::int64_t>& tags);

  // -1 when no node has this tag.
  int find(std::int64_t tag) const;
  // A tag that two nodes have.
  std::optional<std::int64_t> repeated() const;

 private:
  std::vector<std::pair<std::int64_t, int>> sorted_;
};

// Consecutive elements of one type and in the same physical groups.
struct MshBlock {
  const MshType* type;
  std::vector<int> physical;  // tags
  std::vector<int> nodes;     // indices, type->nodes per element, in Gmsh's order
};

struct MshContents {
  std::vector<double> coordinates;  // x, y, z of each node [m]
  NodeTags tags;
  std::vector<MshBlock> blocks;
  std::map<std::pair<int, int>, std::string> names;          // of the physical groups, by dimension and tag
  std::map<std::pair<int, std::string>, int> tags_of_names;  // those that tag_of gave

  // The tag of the group with this name; a new one where there is none.
  int tag_of(int dimension, const std::string& name);
  // The block that an element of this type and groups joins: the last one, or a new one behind it.
  MshBlock& block(const MshType& type, const std::vector<int>& physical);
};

// The type with this number; fails when it is none that is known.
const MshType& msh_type(const Cursor& in, std::int64_t number);

// The nodes have the numbers first, first + 1, ... in the order of the file.
void number_nodes_from(const Cursor& in, std::int64_t first, MshContents& contents);

// An element of this type and in these groups, of nodes given by their tags in the file.
void add_element(const Cursor& in, const MshType& type, const std::vector<int>& physical,
                 const std::vector<std::int64_t>& node_tags, MshContents& contents);

// Closes the list of nodes: fails when two have the same tag.
void number_nodes(const Cursor& in, const std::vector<std::int64_t>& tags, MshContents& contents);

// Adds a node to the element that is being read, the `local`-th of it, at the end of the block: fails when there
// is no node with this tag or when the element has it already.
void add_node(const Cursor& in, const NodeTags& tags, std::int64_t tag, int local, MshBlock& block);

}  // namespace app
