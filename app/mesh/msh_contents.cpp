#include "app/mesh/msh_contents.h"

#include <algorithm>
#include <numeric>

namespace app {

NodeTags::NodeTags(const std::vector<std::int64_t>& tags) {
  sorted_.reserve(tags.size());
  for (const std::int64_t tag : tags) sorted_.emplace_back(tag, static_cast<int>(sorted_.size()));
  std::sort(sorted_.begin(), sorted_.end());
}

int NodeTags::find(std::int64_t tag) const {
  if (sorted_.empty() || tag < sorted_.front().first || tag > sorted_.back().first) return -1;
  // Tags without gaps, the usual case, need no search.
  const auto offset = static_cast<std::uint64_t>(tag) - static_cast<std::uint64_t>(sorted_.front().first);
  if (offset < sorted_.size() && sorted_[offset].first == tag) return sorted_[offset].second;
  const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(tag, 0));
  return found != sorted_.end() && found->first == tag ? found->second : -1;
}

std::optional<std::int64_t> NodeTags::repeated() const {
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  const auto found = std::adjacent_find(sorted_.begin(), sorted_.end(), same);
  if (found == sorted_.end()) return std::nullopt;
  return found->first;
}

MshBlock& MshContents::block(const MshType& type, const std::vector<int>& physical) {
  if (blocks.empty() || blocks.back().type != &type || blocks.back().physical != physical) {
    blocks.push_back({&type, physical, {}});
  }
  return blocks.back();
}

int MshContents::tag_of(int dimension, const std::string& name) {
  const auto [at, is_new] = tags_of_names.try_emplace({dimension, name}, static_cast<int>(tags_of_names.size()) + 1);
  if (is_new) names[{dimension, at->second}] = name;
  return at->second;
}

const MshType& msh_type(const Cursor& in, std::int64_t number) {
  const MshType* type = find_msh_type(number);
  if (type == nullptr) {
    in.fail("element type " + std::to_string(number) +
            " is not known; bodies are made of tri3, tri6, quad4, tet4, tet10 or hex8 (types 2, 9, 3, 4, 11, 5)");
  }
  return *type;
}

void number_nodes(const Cursor& in, const std::vector<std::int64_t>& tags, MshContents& contents) {
  contents.tags = NodeTags(tags);
  if (const auto tag = contents.tags.repeated()) {
    in.fail("two nodes above have the number " + std::to_string(*tag) + "; each node needs its own");
  }
}

void number_nodes_from(const Cursor& in, std::int64_t first, MshContents& contents) {
  std::vector<std::int64_t> tags(contents.coordinates.size() / 3);
  std::iota(tags.begin(), tags.end(), first);
  number_nodes(in, tags, contents);
}

void add_element(const Cursor& in, const MshType& type, const std::vector<int>& physical,
                 const std::vector<std::int64_t>& node_tags, MshContents& contents) {
  MshBlock& block = contents.block(type, physical);
  for (int local = 0; local < type.nodes; ++local)
    add_node(in, contents.tags, node_tags[static_cast<std::size_t>(local)], local, block);
}

void add_node(const Cursor& in, const NodeTags& tags, std::int64_t tag, int local, MshBlock& block) {
  const int node = tags.find(tag);
  if (node < 0) in.fail("an element refers to node " + std::to_string(tag) + ", which is not among the nodes");
  if (std::find(block.nodes.end() - local, block.nodes.end(), node) != block.nodes.end()) {
    in.fail("node " + std::to_string(tag) + " stands twice in one " + std::string(block.type->name) + " element");
  }
  block.nodes.push_back(node);
}

}  // namespace app
