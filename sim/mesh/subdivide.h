// Replaces every element of a mesh by children that share nodes where neighbours meet: what uniform refinement and
// the step from linear to quadratic elements have in common.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "sim/math/vec3.h"
#include "sim/mesh/geometry.h"
#include "sim/mesh/input_error.h"

namespace sim {

// Reference coordinates, in the parent, of a child's nodes.
template <class Child>
using ChildXi = std::array<std::array<double, Child::dimension>, Child::nodes>;

// The corners given, the middles of the edges half-way between them.
template <class E>
ChildXi<E> with_middles(ChildXi<E> xi) {
  if constexpr (E::order == 2) {
    for (const auto& [a, b, middle] : E::edges) {
      for (int k = 0; k < E::dimension; ++k) xi[middle][k] = (xi[a][k] + xi[b][k]) / 2;
    }
  }
  return xi;
}

// Reference coordinates of an element's own nodes.
template <class E>
ChildXi<E> node_xi() {
  ChildXi<E> xi{};
  std::copy(E::corner_xi.begin(), E::corner_xi.end(), xi.begin());
  return with_middles<E>(xi);
}

// A point by the corners that it lies between, and their linear weights in eighths, ascending: the same for every
// element that has the point, so neighbours find each other's nodes exactly.
using PointKey = std::array<std::pair<int, int>, 8>;

template <class E>
PointKey point_key(const int* nodes, const std::array<double, E::dimension>& xi) {
  const auto weights = [&] {
    if constexpr (E::order == 1) {
      return E::N(xi);
    } else {
      return E::Linear::N(xi);
    }
  }();
  PointKey key;
  key.fill({std::numeric_limits<int>::max(), 0});
  for (int i = 0; i < E::corners; ++i) {
    const int eighths = static_cast<int>(std::lround(8 * weights[i]));
    if (eighths > 0) key[i] = {nodes[i], eighths};
  }
  std::sort(key.begin(), key.end());
  return key;
}

// The nodes of the finer mesh. Those of the coarse one come first and keep their numbers.
class PointTable {
 public:
  explicit PointTable(const Eigen::MatrixXd& X);
  // Says which key an existing node has.
  void name(const PointKey& key, int node) { numbers_.try_emplace(key, node); }
  // -1 when there is none.
  int find(const PointKey& key) const;
  int add(const PointKey& key, const Vec3& X);  // the third number is not used in the plane
  int size() const { return coarse_ + static_cast<int>(added_.size()); }
  int coarse_size() const { return coarse_; }
  // Key of an added node, counted from coarse_size().
  const PointKey& key(int node) const { return keys_[node - coarse_]; }
  // dimension x size
  Eigen::MatrixXd positions(const Eigen::MatrixXd& coarse) const;

 private:
  struct Hash {
    std::size_t operator()(const PointKey& key) const;
  };
  int coarse_;
  std::unordered_map<PointKey, int, Hash> numbers_;
  std::vector<Vec3> added_;
  std::vector<PointKey> keys_;
};

// Splits cells (elements or facets): nodes per child x children, in the order of the parents.
// split.operator()<Parent, Child, D>(X_e) returns the children of one parent, a list of ChildXi<Child>.
template <class Parent, class Child, int D, class Split>
Eigen::MatrixXi split_cells(const Eigen::MatrixXd& X, const Eigen::MatrixXi& cells, const Split& split,
                            PointTable& points) {
  Eigen::MatrixXi fine(Child::nodes, 0);
  for (Eigen::Index e = 0; e < cells.cols(); ++e) {
    const int* nodes = cells.data() + e * Parent::nodes;
    const ElementX<Parent, D> X_e = gather<Parent, D>(X, nodes);
    const auto children = split.template operator()<Parent, Child, D>(X_e);
    const auto per_cell = static_cast<Eigen::Index>(children.size());
    if (e == 0) {
      if (static_cast<double>(per_cell) * cells.cols() * Child::nodes > std::numeric_limits<int>::max()) {
        throw InputError("mesh", "the mesh has too many elements to be refined: " + std::to_string(cells.cols()));
      }
      fine.resize(Child::nodes, per_cell * cells.cols());
    }
    for (Eigen::Index c = 0; c < per_cell; ++c) {
      for (int i = 0; i < Child::nodes; ++i) {
        const PointKey key = point_key<Parent>(nodes, children[c][i]);
        const int found = points.find(key);
        if (found >= 0) {
          fine(i, e * per_cell + c) = found;
          continue;
        }
        Vec3 X_new = Vec3::Zero();
        X_new.template head<D>() = position<Parent>(X_e, children[c][i]);
        fine(i, e * per_cell + c) = points.add(key, X_new);
      }
    }
  }
  return fine;
}

// `coarse` with its elements and facets replaced by the given ones; the nodes of these join it, and in a group of
// nodes only those added nodes all of whose corners are in it. per_element: children of an element, numbered in turn.
Group finer_group(const Group& coarse, Eigen::MatrixXi facets, const Eigen::MatrixXi& elements, int per_element,
                  const PointTable& points);

template <class Parent, class Child, int D, class Split>
Mesh subdivide(const Mesh& mesh, const Split& split) {
  PointTable points(mesh.X);
  const auto own = node_xi<Parent>();
  for (int e = 0; e < mesh.element_count(); ++e) {
    const int* nodes = mesh.elements.data() + static_cast<Eigen::Index>(e) * Parent::nodes;
    for (int i = 0; i < Parent::nodes; ++i) points.name(point_key<Parent>(nodes, own[i]), nodes[i]);
  }
  Mesh fine;
  fine.kind = Child::kind;
  fine.elements = split_cells<Parent, Child, D>(mesh.X, mesh.elements, split, points);
  const int per_element = static_cast<int>(fine.elements.cols() / std::max(1, mesh.element_count()));
  const int size = points.size();
  for (const Group& group : mesh.groups) {
    auto facets = split_cells<typename Parent::Facet, typename Child::Facet, D>(mesh.X, group.facets, split, points);
    if (points.size() != size)
      throw InputError("mesh", "a facet of group \"" + group.name + "\" is not one of the mesh");
    fine.groups.push_back(finer_group(group, std::move(facets), fine.elements, per_element, points));
  }
  fine.X = points.positions(mesh.X);
  return fine;
}

}  // namespace sim
