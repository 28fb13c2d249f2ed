#include "sim/mesh/check.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "sim/element/list.h"
#include "sim/mesh/geometry.h"
#include "sim/mesh/input_error.h"

namespace sim {
namespace {

template <class... Part>
[[noreturn]] void refuse(const Part&... parts) {
  std::ostringstream message;
  (message << ... << parts);
  throw InputError("mesh", message.str());
}

void check_shape(const Mesh& mesh) {
  const ElementInfo& element = info(mesh.kind);
  if (mesh.node_count() == 0 || mesh.element_count() == 0) {
    refuse("the mesh is empty: ", mesh.node_count(), " nodes, ", mesh.element_count(), " elements of kind ",
           element.name);
  }
  if (mesh.dimension() < element.dimension || mesh.dimension() > 3) {
    refuse(element.name, " needs ", element.dimension, " to 3 coordinates per node; there are ", mesh.dimension());
  }
  if (mesh.elements.rows() != element.nodes) {
    refuse(element.name, " has ", element.nodes, " nodes; the elements list ", mesh.elements.rows());
  }
}

// Numbers of nodes or elements lie in [0, count).
template <class List>
void check_range(const List& numbers, int count, const std::string& where, const std::string& what) {
  for (const int n : numbers) {
    if (n < 0 || n >= count) {
      refuse(where, " names ", what, " ", n, "; there are ", count, ", counted from 0");
    }
  }
}

void check_indices(const Mesh& mesh) {
  for (int e = 0; e < mesh.element_count(); ++e) {
    check_range(mesh.elements.col(e), mesh.node_count(), "element " + std::to_string(e), "node");
  }
  const int facet_nodes = info(mesh.kind).facet_nodes;
  for (const Group& group : mesh.groups) {
    const std::string where = "group \"" + group.name + "\"";
    check_range(group.nodes, mesh.node_count(), where, "node");
    check_range(group.elements, mesh.element_count(), where, "element");
    if (group.facets.cols() > 0 && group.facets.rows() != facet_nodes) {
      refuse(where, " has facets of ", group.facets.rows(), " nodes; those of ", info(mesh.kind).name, " have ",
             facet_nodes);
    }
    check_range(group.facets.reshaped(), mesh.node_count(), where, "node");
  }
}

void check_finite(const Mesh& mesh) {
  for (int n = 0; n < mesh.node_count(); ++n) {
    if (!mesh.X.col(n).allFinite()) {
      refuse("node ", n, " is at (", mesh.X.col(n).transpose(), "); its coordinates must be finite numbers");
    }
  }
}

// new_number: of every node, -1 for those that go.
void renumber(Group& group, const std::vector<int>& new_number, MeshCheck& report) {
  std::erase_if(group.nodes, [&](int n) { return new_number[n] < 0; });
  for (int& n : group.nodes) n = new_number[n];
  std::vector<int> kept;
  for (int f = 0; f < group.facets.cols(); ++f) {
    const auto facet = group.facets.col(f);
    if (std::all_of(facet.begin(), facet.end(), [&](int n) { return new_number[n] >= 0; })) kept.push_back(f);
  }
  report.dropped_facets += static_cast<int>(group.facets.cols()) - static_cast<int>(kept.size());
  group.facets =
      Eigen::MatrixXi(group.facets(Eigen::indexing::all, kept)).unaryExpr([&](int n) { return new_number[n]; });
}

void drop_unused_nodes(Mesh& mesh, MeshCheck& report) {
  std::vector<int> new_number(mesh.node_count(), -1);
  for (const int n : mesh.elements.reshaped()) new_number[n] = 0;
  std::vector<int> kept;
  for (int n = 0; n < mesh.node_count(); ++n) {
    if (new_number[n] < 0) continue;
    new_number[n] = static_cast<int>(kept.size());
    kept.push_back(n);
  }
  report.dropped_nodes = mesh.node_count() - static_cast<int>(kept.size());
  if (report.dropped_nodes == 0) return;
  mesh.X = Eigen::MatrixXd(mesh.X(Eigen::indexing::all, kept));
  for (int& n : mesh.elements.reshaped()) n = new_number[n];
  for (Group& group : mesh.groups) renumber(group, new_number, report);
}

// Nodal positions less the first one: differences of coordinates are exact where nodes nearly coincide.
template <class E, int D>
ElementX<E, D> from_first_node(const Mesh& mesh, int e) {
  ElementX<E, D> X_e = gather<E, D>(mesh.X, mesh.elements.col(e).data());
  const Position<D> first = X_e.col(0);
  for (int i = 0; i < E::nodes; ++i) X_e.col(i) -= first;
  return X_e;
}

template <class E, int D>
double longest_edge(const Eigen::Matrix<double, D, E::nodes>& X_e) {
  double longest = 0;
  for (const auto& [a, b, middle] : E::edges) longest = std::max(longest, (X_e.col(a) - X_e.col(b)).norm());
  return longest;
}

// det dX/dxi must be positive wherever it is used, and at the corners, where the folds of a quad, a hex or a curved
// element begin.
template <class E, int D>
void check_folds(const Mesh& mesh, int e, double smallest) {
  const ElementX<E, D> X_e = from_first_node<E, D>(mesh, e);
  const auto require_positive = [&](const std::array<double, E::dimension>& xi) {
    const double ratio = measure_ratio(jacobian<E>(X_e, xi));
    if (ratio > smallest) return;
    const Position<D> at = mesh.X.col(mesh.elements(0, e)) + position<E>(X_e, xi);
    refuse("element ", e, " (", E::name, ") is folded: det dX/dxi = ", ratio, " at (", at.transpose(),
           "); its nodes are out of order or too far off their edges");
  };
  for (const auto& xi : E::corner_xi) require_positive(xi);
  for (const auto& point : E::rule) require_positive(point.xi);
  for (const auto& point : E::mass_rule) require_positive(point.xi);
}

template <class E, int D>
void orient(Mesh& mesh, MeshCheck& report) {
  for (int e = 0; e < mesh.element_count(); ++e) {
    const ElementX<E, D> X_e = from_first_node<E, D>(mesh, e);
    const double longest = longest_edge<E>(X_e), smallest = 1e-14 * std::pow(longest, E::dimension);
    const double m = measure<E>(X_e, E::mass_rule);
    if (!(std::abs(m) > smallest)) {
      refuse("element ", e, " (", E::name, ") has no ", E::dimension == 3 ? "volume: " : "area: ", m,
             E::dimension == 3 ? " m^3" : " m^2", ", longest edge ", longest, " m; nodes ",
             mesh.elements.col(e).transpose(), " must not coincide or lie flat");
    }
    if (m < 0) {
      const Eigen::Matrix<int, E::nodes, 1> nodes = mesh.elements.col(e);
      for (int i = 0; i < E::nodes; ++i) mesh.elements(i, e) = nodes[E::mirrored[i]];
      ++report.reoriented;
    }
    check_folds<E, D>(mesh, e, smallest);
  }
}

}  // namespace

MeshCheck check_and_orient(Mesh& mesh) {
  check_shape(mesh);
  check_indices(mesh);
  check_finite(mesh);
  MeshCheck report;
  visit_mesh(
      mesh, [&]<class E, int D>(std::type_identity<E>, std::integral_constant<int, D>) { orient<E, D>(mesh, report); });
  drop_unused_nodes(mesh, report);  // last, so that the messages above have the numbers of the input
  return report;
}

}  // namespace sim
