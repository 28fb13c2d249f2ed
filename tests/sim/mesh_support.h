// Sample meshes and measures that the mesh tests share.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "sim/element/list.h"
#include "sim/mesh/boundary.h"
#include "sim/mesh/generate.h"
#include "sim/mesh/geometry.h"
#include "sim/mesh/input_error.h"
#include "sim/scene.h"

namespace sim::test {

inline constexpr ElementKind all_kinds[] = {ElementKind::tri3, ElementKind::tri6,  ElementKind::quad4,
                                            ElementKind::tet4, ElementKind::tet10, ElementKind::hex8};

inline std::string kind_name(const testing::TestParamInfo<ElementKind>& test) {
  return std::string(info(test.param).name);
}

// 2 x 1.5 (x 0.7) m, graded.
inline Mesh sample(ElementKind kind, int nx = 3, int ny = 2, int nz = 2) {
  if (info(kind).dimension == 2) return generate_rectangle({2, 1.5}, {nx, ny}, {1.6, 0.8}, kind);
  return generate_box({2, 1.5, 0.7}, {nx, ny, nz}, {1.6, 0.8, 1.2}, kind);
}

// Every node is moved by a smooth field: edges of quadratic elements become curved, faces of hexes warped.
inline Mesh bent(Mesh mesh) {
  for (auto X : mesh.X.colwise()) {
    const double z = X.size() == 3 ? X[2] : 0.0;
    const Vec3 u(0.06 * std::sin(2 * X[1] + z), 0.08 * std::sin(2 * X[0]) + 0.03 * z * X[0], 0.05 * X[0] * X[1]);
    X += u.head(X.size());
  }
  return mesh;
}

// Area or volume from the elements, with sign.
inline double total_measure(const Mesh& mesh) {
  double sum = 0;
  visit_mesh(mesh, [&]<class E, int D>(std::type_identity<E>, std::integral_constant<int, D>) {
    for (const auto& nodes : mesh.elements.colwise()) {
      sum += measure<E>(gather<E, D>(mesh.X, nodes.data()), E::mass_rule);
    }
  });
  return sum;
}

template <class F>
constexpr const auto& load_rule() {
  if constexpr (F::dimension == 1) {
    return F::rule;
  } else {
    return F::mass_rule;
  }
}

// Length or area of the given facets of elements of this kind.
inline double facet_measure(const Mesh& mesh, const Eigen::MatrixXi& facets) {
  double sum = 0;
  visit_mesh(mesh, [&]<class E, int D>(std::type_identity<E>, std::integral_constant<int, D>) {
    using F = typename E::Facet;
    for (const auto& nodes : facets.colwise()) sum += measure<F>(gather<F, D>(mesh.X, nodes.data()), load_rule<F>());
  });
  return sum;
}

// Outward normal of a facet times its measure ratio.
inline Eigen::Vector2d scaled_normal(const Eigen::Vector2d& J) {
  return {J[1], -J[0]};
}
inline Vec3 scaled_normal(const Eigen::Matrix<double, 3, 2>& J) {
  return J.col(0).cross(J.col(1));
}

// Divergence theorem: measure = 1/d int X . n dA over the boundary. Right only when every facet points outward.
inline double enclosed_measure(const Mesh& mesh) {
  double sum = 0;
  const Eigen::MatrixXi facets = boundary_facets(mesh);
  visit_mesh(mesh, [&]<class E, int D>(std::type_identity<E>, std::integral_constant<int, D>) {
    using F = typename E::Facet;
    if constexpr (D == E::dimension) {
      for (const auto& nodes : facets.colwise()) {
        const auto X_f = gather<F, D>(mesh.X, nodes.data());
        for (const auto& [xi, w] : load_rule<F>()) {
          sum += w * position<F>(X_f, xi).dot(scaled_normal(jacobian<F>(X_f, xi))) / D;
        }
      }
    }
  });
  return sum;
}

// Vertices - edges + faces - cells over corner nodes: 1 for every mesh without holes.
inline int euler_characteristic(const Mesh& mesh) {
  std::set<int> vertices;
  std::set<std::pair<int, int>> edges;
  const ElementInfo& element = info(mesh.kind);
  for (const auto& e : mesh.elements.colwise()) {
    vertices.insert(e.begin(), e.begin() + element.corners);
    for (const auto& [a, b, middle] : element.edges) edges.insert(std::minmax(e[a], e[b]));
  }
  const int surface = static_cast<int>(boundary_facets(mesh).cols());
  const int per_element = static_cast<int>(element.facets.size()) / element.facet_nodes;
  const int corner_count = static_cast<int>(vertices.size()), edge_count = static_cast<int>(edges.size());
  if (element.dimension == 2) return corner_count - edge_count + mesh.element_count();
  const int faces = (mesh.element_count() * per_element + surface) / 2;
  return corner_count - edge_count + faces - mesh.element_count();
}

inline const Group& group(const Mesh& mesh, const std::string& name) {
  for (const Group& g : mesh.groups) {
    if (g.name == name) return g;
  }
  throw std::out_of_range(name);
}

// Runs f and returns what the InputError says, after checking its key.
template <class F>
std::string error_of(const std::string& key, const F& f) {
  try {
    f();
  } catch (const InputError& error) {
    EXPECT_EQ(error.key, key);
    return error.what();
  }
  ADD_FAILURE() << "no InputError";
  return "";
}

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

}  // namespace sim::test
