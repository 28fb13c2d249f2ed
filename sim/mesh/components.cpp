#include "sim/mesh/components.h"

#include <algorithm>
#include <numeric>

namespace sim {

namespace {

// The number of the lowest node that is connected with each node.
std::vector<int> lowest_connected(const Mesh& mesh) {
  std::vector<int> root(mesh.node_count());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& nodes : mesh.elements.colwise())
    for (const int node : nodes) {
      const int a = find(node), b = find(nodes[0]);
      root[std::max(a, b)] = std::min(a, b);
    }
  for (int i = 0; i < mesh.node_count(); ++i) root[i] = find(i);
  return root;
}

}  // namespace

std::vector<Component> components(const Mesh& mesh) {
  const std::vector<int> root = lowest_connected(mesh);
  std::vector<int> number(root.size(), -1);
  std::vector<Component> all;
  for (int i = 0; i < mesh.node_count(); ++i) {
    int& own = number[root[i]];
    if (own < 0) {
      own = static_cast<int>(all.size());
      all.emplace_back();
    }
    all[own].nodes.push_back(i);
  }
  for (int e = 0; e < mesh.element_count(); ++e) all[number[root[mesh.elements(0, e)]]].elements.push_back(e);
  return all;
}

}  // namespace sim
