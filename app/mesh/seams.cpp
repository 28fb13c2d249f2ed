#include "app/mesh/seams.h"

#include <algorithm>
#include <array>

#include "sim/mesh/boundary.h"

namespace app {
namespace {

using Place = std::array<double, 3>;

Place place_of(const sim::Mesh& mesh, int node) {
  return {mesh.X(0, node) + 0.0, mesh.X(1, node) + 0.0, mesh.X(2, node) + 0.0};  // -0 becomes 0
}

// The nodes of edges that belong to one triangle only.
std::vector<int> open_nodes(const sim::Mesh& mesh) {
  const Eigen::MatrixXi edges = sim::boundary_facets(mesh);
  std::vector<int> nodes(edges.data(), edges.data() + edges.size());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace

void join_seams(sim::Mesh& mesh, std::string_view name, std::vector<std::string>& remarks) {
  std::vector<int> nodes = open_nodes(mesh);
  std::stable_sort(nodes.begin(), nodes.end(), [&](int a, int b) { return place_of(mesh, a) < place_of(mesh, b); });
  std::vector<int> target(static_cast<std::size_t>(mesh.node_count()));
  for (int node = 0; node < mesh.node_count(); ++node) target[static_cast<std::size_t>(node)] = node;
  int joined = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (place_of(mesh, nodes[i]) != place_of(mesh, nodes[i - 1])) continue;
    target[static_cast<std::size_t>(nodes[i])] = target[static_cast<std::size_t>(nodes[i - 1])];
    ++joined;
  }
  if (joined == 0) return;
  for (int& node : mesh.elements.reshaped()) node = target[static_cast<std::size_t>(node)];
  remarks.push_back(std::string(name) +
                    ": nodes of open edges that stand where others do, joined with them: " + std::to_string(joined));
}

}  // namespace app
