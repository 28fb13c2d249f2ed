#include "app/mesh/msh40.h"

namespace app {
namespace {

// One entity's nodes: tag, coordinates and parameters on the entity, if any, of each.
void read_node_block_40(MshFields& in, std::vector<std::int64_t>& tags, MshContents& contents) {
  in.tag("the tag of an entity");
  const int dimension = in.integer("the dimension of an entity", 0, 3);
  const int parameters = in.integer("the parametric flag", 0, 1) * dimension;
  const int count = in.count("the number of nodes in a block", 8, 28);
  for (int i = 0; i < count; ++i) {
    tags.push_back(in.tag("the tag of a node"));
    for (const char* axis : {"x", "y", "z"}) contents.coordinates.push_back(in.real(axis));
    for (int p = 0; p < parameters; ++p) in.real("a parameter of a node");
  }
}

}  // namespace

void read_msh40_nodes(MshFields& in, MshContents& contents) {
  const int blocks = in.count("the number of node blocks", 8, 20);
  const int total = in.count("the number of nodes", 8, 28);
  std::vector<std::int64_t> tags;
  for (int b = 0; b < blocks; ++b) read_node_block_40(in, tags, contents);
  check_msh4_total(in.cursor(), total, tags.size(), "nodes");
  number_nodes(in.cursor(), tags, contents);
}

void read_msh40_elements(MshFields& in, const MshEntities& entities, MshContents& contents) {
  const int blocks = in.count("the number of element blocks", 8, 20);
  const int total = in.count("the number of elements", 4, 8);
  std::size_t sum = 0;
  for (int b = 0; b < blocks; ++b) {
    const int tag = in.tag("the tag of an entity");
    const auto entity = entities.find({in.integer("the dimension of an entity", 0, 3), tag});
    const MshType& type = msh_type(in.cursor(), in.tag("the type of elements"));
    const auto numbers = static_cast<std::size_t>(type.nodes) + 1;
    const int count = in.count("the number of elements in a block", 2 * numbers, 4 * numbers);
    MshBlock& block = contents.block(type, entity == entities.end() ? std::vector<int>{} : entity->second);
    for (int i = 0; i < count; ++i) {
      in.tag("the tag of an element");
      for (int local = 0; local < type.nodes; ++local)
        add_node(in.cursor(), contents.tags, in.tag("a node of an element"), local, block);
    }
    sum += static_cast<std::size_t>(count);
  }
  check_msh4_total(in.cursor(), total, sum, "elements");
}

}  // namespace app
