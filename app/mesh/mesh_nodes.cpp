#include "app/mesh/mesh_nodes.h"

#include <algorithm>
#include <numeric>
#include <sstream>

#include "app/mesh/error.h"
#include "sim/element/element.h"

namespace app {

std::vector<int> keep_used_nodes(sim::Mesh& mesh, std::string_view name, std::vector<std::string>& remarks) {
  std::vector<int> index(static_cast<std::size_t>(mesh.node_count()), -1);
  for (const int node : mesh.elements.reshaped()) index[static_cast<std::size_t>(node)] = 0;
  int used = 0;
  for (int node = 0; node < mesh.node_count(); ++node) {
    int& target = index[static_cast<std::size_t>(node)];
    if (target < 0) continue;
    target = used;
    mesh.X.col(used++) = mesh.X.col(node);
  }
  if (used == mesh.node_count()) return index;
  remarks.push_back(std::string(name) + ": nodes of no element, left out: " + std::to_string(mesh.node_count() - used) +
                    " of " + std::to_string(mesh.node_count()));
  mesh.X.conservativeResize(Eigen::NoChange, used);
  for (int& node : mesh.elements.reshaped()) node = index[static_cast<std::size_t>(node)];
  return index;
}

void flatten(sim::Mesh& mesh, std::string_view name) {
  const sim::ElementInfo& element = sim::info(mesh.kind);
  if (element.dimension == 3) return;
  constexpr double rounding = 1e-12;  // relative to the size of the mesh
  const Eigen::Vector3d extent = mesh.X.rowwise().maxCoeff() - mesh.X.rowwise().minCoeff();
  if (extent.z() <= rounding * extent.maxCoeff()) {
    mesh.X.conservativeResize(2, Eigen::NoChange);
  } else if (!element.membrane) {
    std::ostringstream range;
    range << mesh.X.row(2).minCoeff() << " to " << mesh.X.row(2).maxCoeff();
    throw FileError(std::string(name) + ": the z of " + std::string(element.name) + " elements goes from " +
                    range.str() + "; it should be the same for all (a membrane in space is made of triangles)");
  }
}

std::vector<int> first_equal_column(const Eigen::MatrixXi& columns) {
  Eigen::MatrixXi sets = columns;
  for (auto set : sets.colwise()) std::sort(set.begin(), set.end());
  std::vector<int> order(static_cast<std::size_t>(sets.cols()));
  std::iota(order.begin(), order.end(), 0);
  const auto compare = [&sets](int a, int b) {
    const auto [at, other] = std::mismatch(sets.col(a).begin(), sets.col(a).end(), sets.col(b).begin());
    return at == sets.col(a).end() ? 0 : *at - *other;
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const int difference = compare(a, b);
    return difference == 0 ? a < b : difference < 0;
  });
  std::vector<int> first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && compare(order[i - 1], order[i]) == 0;
    first[static_cast<std::size_t>(order[i])] = repeats ? first[static_cast<std::size_t>(order[i - 1])] : order[i];
  }
  return first;
}

}  // namespace app
