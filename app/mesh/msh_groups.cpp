#include "app/mesh/msh_groups.h"

#include <algorithm>

#include "app/mesh/error.h"
#include "app/mesh/mesh_nodes.h"
#include "sim/element/element.h"

namespace app {
namespace {

// What a group has gathered. A thing may be there more than once: MSH 2 repeats elements.
struct Part {
  std::vector<int> nodes, elements, facets;
};

using Key = std::pair<int, int>;  // dimension and tag of a physical group

void sort_unique(std::vector<int>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

Eigen::MatrixXi unique_facets(const std::vector<int>& nodes, int facet_nodes) {
  const auto count = static_cast<Eigen::Index>(nodes.size()) / facet_nodes;
  Eigen::MatrixXi facets = Eigen::Map<const Eigen::MatrixXi>(nodes.data(), facet_nodes, count);
  const std::vector<int> first = first_equal_column(facets);
  Eigen::Index unique = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    if (first[static_cast<std::size_t>(i)] == i) facets.col(unique++) = facets.col(i);
  }
  facets.conservativeResize(Eigen::NoChange, unique);
  return facets;
}

class Groups {
 public:
  Groups(const MshContents& contents, const MshIndex& index, const std::string& name)
      : contents_(contents), index_(index), name_(name), facet_nodes_(index.body->element->facet_nodes) {}

  void gather() {
    std::size_t body_element = 0;
    for (const MshBlock& block : contents_.blocks) {
      if (block.type->dimension < index_.body->dimension) check_facets(block);
      const auto nodes = static_cast<std::size_t>(block.type->nodes);
      for (std::size_t at = 0; at < block.nodes.size(); at += nodes) {
        const bool body = block.type == index_.body;
        add(block, at, body ? index_.elements[body_element++] : -1);
      }
    }
  }

  std::vector<sim::Group> finish(std::vector<std::string>& remarks) {
    remark(remarks);
    std::vector<sim::Group> groups;
    for (auto& [key, part] : merge_names(remarks)) {
      sort_unique(part.nodes);
      sort_unique(part.elements);
      groups.push_back({key.second, std::move(part.nodes), std::move(part.elements), {}, key.first});
      if (!part.facets.empty()) groups.back().facets = unique_facets(part.facets, facet_nodes_);
    }
    return groups;
  }

 private:
  bool is_facet(const MshType& type) const { return type.dimension == index_.body->dimension - 1; }

  void check_facets(const MshBlock& block) const {
    if (block.physical.empty() || block.nodes.empty() || !is_facet(*block.type)) return;
    if (block.type->nodes == facet_nodes_) return;
    throw FileError(name_ + ": physical group " + group_name({block.type->dimension, block.physical[0]}) +
                    " is made of " + std::string(block.type->name) + "; a facet of " + std::string(index_.body->name) +
                    " has " + std::to_string(facet_nodes_) + " nodes");
  }

  // The element of the block whose nodes start at `at`; element: its index in the mesh, -1 for lower dimensions.
  void add(const MshBlock& block, std::size_t at, int element) {
    std::vector<int> nodes;
    for (int i = 0; i < block.type->nodes; ++i) {
      nodes.push_back(index_.nodes[static_cast<std::size_t>(block.nodes[at + static_cast<std::size_t>(i)])]);
    }
    if (std::find(nodes.begin(), nodes.end(), -1) != nodes.end()) {
      apart_ += !block.physical.empty();
      return;
    }
    for (const int tag : block.physical) {
      Part& part = parts_[{block.type->dimension, tag}];
      part.nodes.insert(part.nodes.end(), nodes.begin(), nodes.end());
      if (element >= 0) part.elements.push_back(element);
      if (is_facet(*block.type)) part.facets.insert(part.facets.end(), nodes.begin(), nodes.end());
    }
  }

  std::string group_name(const Key& key) const {
    const auto found = contents_.names.find(key);
    return found == contents_.names.end() || found->second.empty() ? std::to_string(key.second) : found->second;
  }

  void remark(std::vector<std::string>& remarks) const {
    if (apart_ > 0) {
      remarks.push_back(name_ +
                        ": elements of groups that do not lie on the body, left out: " + std::to_string(apart_));
    }
    for (const auto& [key, group] : contents_.names) {
      if (parts_.count(key) == 0) remarks.push_back(name_ + ": the physical group " + quote(group) + " is empty");
    }
  }

  // By dimension and name, in the order of dimension and tag. Two groups of one dimension with one name are one.
  std::vector<std::pair<std::pair<int, std::string>, Part>> merge_names(std::vector<std::string>& remarks) {
    std::vector<std::pair<std::pair<int, std::string>, Part>> merged;
    for (auto& [key, part] : parts_) {
      const std::pair<int, std::string> group = {key.first, group_name(key)};
      const auto at = std::ranges::find(merged, group, &std::pair<std::pair<int, std::string>, Part>::first);
      if (at == merged.end()) {
        merged.emplace_back(group, std::move(part));
        continue;
      }
      remarks.push_back(name_ + ": several physical groups of dimension " + std::to_string(group.first) +
                        " are called " + quote(group.second) + ": taken as one");
      for (const auto list : {&Part::nodes, &Part::elements, &Part::facets}) {
        (at->second.*list).insert((at->second.*list).end(), (part.*list).begin(), (part.*list).end());
      }
    }
    return merged;
  }

  const MshContents& contents_;
  const MshIndex& index_;
  const std::string& name_;
  int facet_nodes_;
  std::map<Key, Part> parts_;
  std::size_t apart_ = 0;
};

}  // namespace

std::vector<sim::Group> make_groups(const MshContents& contents, const MshIndex& index, const std::string& name,
                                    std::vector<std::string>& remarks) {
  Groups groups(contents, index, name);
  groups.gather();
  return groups.finish(remarks);
}

}  // namespace app
