#include "app/mesh/msh1.h"

namespace app {

// How many; then number, type, physical and elementary group (0: none), number of nodes and nodes of each.
void read_msh1_elements(MshFields& in, MshContents& contents) {
  const int count = in.count("the number of elements", 12, 12);
  for (int i = 0; i < count; ++i) {
    in.tag("the number of an element");
    const MshType& type = msh_type(in.cursor(), in.tag("the type of an element"));
    const int physical = std::abs(in.tag("the physical group"));
    in.tag("the elementary group");
    in.integer("the number of nodes", type.nodes, type.nodes);
    MshBlock& block = contents.block(type, physical == 0 ? std::vector<int>{} : std::vector<int>{physical});
    for (int local = 0; local < type.nodes; ++local)
      add_node(in.cursor(), contents.tags, in.tag("a node of an element"), local, block);
  }
}

}  // namespace app
