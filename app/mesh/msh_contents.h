// What a Gmsh file says, before a mesh is made of it: nodes, elements and physical groups, whatever its version.
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
  std::map<std::pair<int, int>, std::string> names;  // of the physical groups, by dimension and tag

  // The block that an element of this type and groups joins: the last one, or a new one behind it.
  MshBlock& block(const MshType& type, const std::vector<int>& physical);
};

// The type with this number; fails when it is none that is known.
const MshType& msh_type(const Cursor& in, std::int64_t number);

// Closes the list of nodes: fails when two have the same tag.
void number_nodes(const Cursor& in, const std::vector<std::int64_t>& tags, MshContents& contents);

// Adds a node to the element that is being read, the `local`-th of it, at the end of the block: fails when there
// is no node with this tag or when the element has it already.
void add_node(const Cursor& in, const NodeTags& tags, std::int64_t tag, int local, MshBlock& block);

}  // namespace app
