#include "sim/mesh/boundary.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "sim/element/list.h"

namespace sim {
namespace {

// A facet by its corner nodes in ascending order: the same for every element that has it.
struct FacetUse {
  std::array<int, 4> corners;
  int element, local;
};

template <class E>
std::vector<FacetUse> sorted_facets(const Mesh& mesh) {
  constexpr int per_element = static_cast<int>(E::facets.size()) / E::Facet::nodes;
  std::vector<FacetUse> uses;
  uses.reserve(static_cast<std::size_t>(mesh.element_count()) * per_element);
  for (int e = 0; e < mesh.element_count(); ++e) {
    for (int f = 0; f < per_element; ++f) {
      FacetUse use{{-1, -1, -1, -1}, e, f};
      for (int i = 0; i < E::Facet::corners; ++i) {
        use.corners[i] = mesh.elements(E::facets[f * E::Facet::nodes + i], e);
      }
      std::sort(use.corners.begin(), use.corners.begin() + E::Facet::corners);
      uses.push_back(use);
    }
  }
  std::sort(uses.begin(), uses.end(), [](const FacetUse& a, const FacetUse& b) {
    return std::tie(a.corners, a.element, a.local) < std::tie(b.corners, b.element, b.local);
  });
  return uses;
}

template <class E>
Boundary boundary_of(const Mesh& mesh) {
  const auto uses = sorted_facets<E>(mesh);
  Boundary result;
  std::vector<FacetUse> single;
  for (auto first = uses.begin(); first != uses.end();) {
    const auto last = std::find_if(first, uses.end(), [&](const FacetUse& u) { return u.corners != first->corners; });
    if (last - first == 1) single.push_back(*first);
    if (last - first > 2) ++result.non_manifold;
    first = last;
  }
  std::sort(single.begin(), single.end(), [](const FacetUse& a, const FacetUse& b) {
    return std::tie(a.element, a.local) < std::tie(b.element, b.local);
  });
  result.facets.resize(E::Facet::nodes, static_cast<Eigen::Index>(single.size()));
  for (std::size_t k = 0; k < single.size(); ++k) {
    result.elements.push_back(single[k].element);
    for (int i = 0; i < E::Facet::nodes; ++i) {
      result.facets(i, k) = mesh.elements(E::facets[single[k].local * E::Facet::nodes + i], single[k].element);
    }
  }
  return result;
}

}  // namespace

Boundary boundary(const Mesh& mesh) {
  return visit_element(mesh.kind, [&]<class E>(std::type_identity<E>) { return boundary_of<E>(mesh); });
}

Eigen::MatrixXi boundary_facets(const Mesh& mesh) {
  return boundary(mesh).facets;
}

Eigen::MatrixXi surface_facets(const Mesh& mesh) {
  return info(mesh.kind).dimension == 3 ? boundary_facets(mesh) : mesh.elements;
}

}  // namespace sim
