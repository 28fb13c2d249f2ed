#include "sim/mesh/merge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace sim {
namespace {

using GridCell = std::array<std::int64_t, 3>;

// The first node within the distance of each, itself where there is none: nodes lie in cubes as wide as the distance,
// so that only neighbouring cubes are searched.
std::vector<int> first_at_place(const Mesh& mesh, double distance) {
  constexpr double least = 1e-300;
  const double width = std::max(distance, least);
  const int D = mesh.dimension();
  const Eigen::VectorXd low = mesh.X.rowwise().minCoeff();
  std::map<GridCell, std::vector<int>> cubes;  // the nodes that are first at their place
  std::vector<int> first(mesh.node_count());
  for (int n = 0; n < mesh.node_count(); ++n) {
    GridCell cube = {0, 0, 0};
    for (int i = 0; i < D; ++i)
      cube[i] = static_cast<std::int64_t>(std::min(std::floor((mesh.X(i, n) - low[i]) / width), 4e18));
    first[n] = n;
    for (int k = 0; k < 27 && first[n] == n; ++k) {
      const auto near = cubes.find({cube[0] + k % 3 - 1, cube[1] + k / 3 % 3 - 1, cube[2] + k / 9 - 1});
      if (near == cubes.end()) continue;
      for (const int other : near->second)
        if ((mesh.X.col(n) - mesh.X.col(other)).norm() <= distance && first[n] == n) first[n] = other;
    }
    if (first[n] == n) cubes[cube].push_back(n);
  }
  return first;
}

// The elements whose nodes are all different; new_number: of every element, -1 for those that go.
std::vector<int> drop_collapsed(Mesh& mesh) {
  std::vector<int> new_number(mesh.element_count(), -1);
  int kept = 0;
  for (int e = 0; e < mesh.element_count(); ++e) {
    Eigen::VectorXi nodes = mesh.elements.col(e);
    std::sort(nodes.begin(), nodes.end());
    if (std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end()) continue;
    mesh.elements.col(kept) = Eigen::VectorXi(mesh.elements.col(e));
    new_number[e] = kept++;
  }
  mesh.elements.conservativeResize(Eigen::NoChange, kept);
  return new_number;
}

void sort_unique_numbers(std::vector<int>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

double coincidence(const Mesh& mesh) {
  constexpr double single = 1e-7;
  return single * (mesh.X.rowwise().maxCoeff() - mesh.X.rowwise().minCoeff()).maxCoeff();
}

int count_coincident(const Mesh& mesh, double distance) {
  const std::vector<int> first = first_at_place(mesh, distance);
  int count = 0;
  for (int n = 0; n < mesh.node_count(); ++n) count += first[n] != n;
  return count;
}

Joined join_coincident(Mesh& mesh, double distance) {
  const std::vector<int> first = first_at_place(mesh, distance);
  std::vector<int> number(mesh.node_count());
  int kept = 0;
  for (int n = 0; n < mesh.node_count(); ++n) {
    if (first[n] != n) continue;
    mesh.X.col(kept) = Eigen::VectorXd(mesh.X.col(n));
    number[n] = kept++;
  }
  const auto new_node = [&](int n) { return number[first[n]]; };
  Joined joined{mesh.node_count() - kept, mesh.element_count()};
  mesh.X.conservativeResize(Eigen::NoChange, kept);
  mesh.elements = mesh.elements.unaryExpr(new_node).eval();
  const std::vector<int> new_element = drop_collapsed(mesh);
  joined.elements -= mesh.element_count();
  for (Group& group : mesh.groups) {
    for (int& n : group.nodes) n = new_node(n);
    sort_unique_numbers(group.nodes);
    std::erase_if(group.elements, [&](int e) { return new_element[e] < 0; });
    for (int& e : group.elements) e = new_element[e];
    group.facets = group.facets.unaryExpr(new_node).eval();
  }
  return joined;
}

}  // namespace sim
