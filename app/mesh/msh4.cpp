#include "app/mesh/msh4.h"

#include <array>
#include <cstdlib>

namespace app {
namespace {

// Bounding box (a point's place, for a point), physical tags, and the entities that bound it.
std::vector<int> read_entity(MshFields& in, int dimension, int point_numbers) {
  for (int i = 0; i < (dimension == 0 ? point_numbers : 6); ++i) in.real("a coordinate of an entity");
  std::vector<int> physical;
  const int tag_count = in.count("the number of physical tags", 2, 4);
  for (int i = 0; i < tag_count; ++i) {
    physical.push_back(std::abs(in.tag("a physical tag")));
  }
  if (dimension == 0) return physical;
  const int bounds = in.count("the number of bounding entities", 2, 4);
  for (int i = 0; i < bounds; ++i) in.tag("a bounding entity");
  return physical;
}

// One entity's nodes: first their tags, then their coordinates, followed by the parameters on the entity if any.
void read_node_block(MshFields& in, std::vector<std::int64_t>& tags, MshContents& contents) {
  const int dimension = in.integer("the dimension of an entity", 0, 3);
  in.tag("the tag of an entity");
  const int parameters = in.integer("the parametric flag", 0, 1) * dimension;
  const int count = in.count("the number of nodes in a block", 8, 32);
  for (int i = 0; i < count; ++i) tags.push_back(in.size("the tag of a node"));
  for (int i = 0; i < count; ++i) {
    for (const char* axis : {"x", "y", "z"}) contents.coordinates.push_back(in.real(axis));
    for (int p = 0; p < parameters; ++p) in.real("a parameter of a node");
  }
}

}  // namespace

void check_msh4_total(const Cursor& in, std::int64_t total, std::size_t sum, std::string_view what) {
  if (total == static_cast<std::int64_t>(sum)) return;
  in.fail("the section announces " + std::to_string(total) + " " + std::string(what) + ", but its blocks have " +
          std::to_string(sum));
}

MshEntities read_msh4_entities(MshFields& in, int point_numbers) {
  std::array<int, 4> counts;
  for (int& count : counts) count = in.count("the number of entities", 10, 36);
  MshEntities entities;
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (int i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
      const int tag = in.tag("the tag of an entity");
      entities[{dimension, tag}] = read_entity(in, dimension, point_numbers);
    }
  }
  return entities;
}

// In front: how many partitions, and the entities of ghosts. Each entity says which one it is a part of, and in which
// partitions, before what other entities say.
void read_msh4_partitions(MshFields& in, int point_numbers, MshEntities& entities) {
  in.size("the number of partitions");
  const int ghosts = in.count("the number of ghost entities", 4, 8);
  for (int i = 0; i < 2 * ghosts; ++i) in.tag("a ghost entity");
  std::array<int, 4> counts;
  for (int& count : counts) count = in.count("the number of entities", 10, 36);
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (int i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
      const int tag = in.tag("the tag of an entity");
      in.tag("the dimension of the parent");
      in.tag("the tag of the parent");
      const int partitions = in.count("the number of partitions of an entity", 2, 4);
      for (int p = 0; p < partitions; ++p) in.tag("a partition");
      entities[{dimension, tag}] = read_entity(in, dimension, point_numbers);
    }
  }
}

void read_msh4_nodes(MshFields& in, MshContents& contents) {
  const int blocks = in.count("the number of node blocks", 8, 20);
  const int total = in.count("the number of nodes", 8, 32);
  in.size("the smallest node tag");
  in.size("the largest node tag");
  std::vector<std::int64_t> tags;
  tags.reserve(static_cast<std::size_t>(total));
  contents.coordinates.reserve(3 * static_cast<std::size_t>(total));
  for (int b = 0; b < blocks; ++b) read_node_block(in, tags, contents);
  check_msh4_total(in.cursor(), total, tags.size(), "nodes");
  number_nodes(in.cursor(), tags, contents);
}

void read_msh4_elements(MshFields& in, const MshEntities& entities, MshContents& contents) {
  const int blocks = in.count("the number of element blocks", 8, 20);
  const int total = in.count("the number of elements", 4, 16);
  in.size("the smallest element tag");
  in.size("the largest element tag");
  std::size_t sum = 0;
  for (int b = 0; b < blocks; ++b) {
    const int dimension = in.integer("the dimension of an entity", 0, 3);
    const auto entity = entities.find({dimension, in.tag("the tag of an entity")});
    const MshType& type = msh_type(in.cursor(), in.tag("the type of elements"));
    const auto numbers = static_cast<std::size_t>(type.nodes) + 1;
    const int count = in.count("the number of elements in a block", 2 * numbers, 8 * numbers);
    MshBlock& block = contents.block(type, entity == entities.end() ? std::vector<int>{} : entity->second);
    for (int i = 0; i < count; ++i) {
      in.size("the tag of an element");
      for (int local = 0; local < type.nodes; ++local) {
        add_node(in.cursor(), contents.tags, in.size("a node of an element"), local, block);
      }
    }
    sum += static_cast<std::size_t>(count);
  }
  check_msh4_total(in.cursor(), total, sum, "elements");
}

}  // namespace app
