// The map of an element from its reference coordinates into space, at rest, and sizes that follow from it.
// E is an element or a facet, D the dimension of space: E::dimension or more.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <type_traits>

#include "sim/element/list.h"
#include "sim/mesh/mesh.h"

namespace sim {

// Nodal positions of one element or facet [m].
template <class E, int D>
using ElementX = Eigen::Matrix<double, D, E::nodes>;
template <int D>
using Position = Eigen::Matrix<double, D, 1>;
// dX/dxi
template <class E, int D>
using Jacobian = Eigen::Matrix<double, D, E::dimension>;

// Returns f(std::type_identity<E>{}, std::integral_constant<int, D>{}) for the mesh's element and dimension.
template <class F>
decltype(auto) visit_mesh(const Mesh& mesh, F&& f) {
  return visit_element(mesh.kind, [&]<class E>(std::type_identity<E> element) {
    if constexpr (E::dimension == 2) {
      if (mesh.dimension() == 2) return f(element, std::integral_constant<int, 2>{});
    }
    return f(element, std::integral_constant<int, 3>{});
  });
}

// `nodes` points to E::nodes node numbers.
template <class E, int D>
ElementX<E, D> gather(const Eigen::MatrixXd& X, const int* nodes) {
  ElementX<E, D> X_e;
  for (int i = 0; i < E::nodes; ++i) {
    for (int r = 0; r < D; ++r) X_e(r, i) = X(r, nodes[i]);
  }
  return X_e;
}

// X(xi) = sum_i X_i N_i(xi)
template <class E, int D>
Position<D> position(const Eigen::Matrix<double, D, E::nodes>& X_e, const std::array<double, E::dimension>& xi) {
  const auto N = E::N(xi);
  Position<D> X = Position<D>::Zero();
  for (int i = 0; i < E::nodes; ++i) X += N[i] * X_e.col(i);
  return X;
}

// dX/dxi = sum_i X_i dN_i/dxi
template <class E, int D>
Jacobian<E, D> jacobian(const Eigen::Matrix<double, D, E::nodes>& X_e, const std::array<double, E::dimension>& xi) {
  const auto dN = E::dN(xi);
  Jacobian<E, D> J = Jacobian<E, D>::Zero();
  for (int i = 0; i < E::nodes; ++i) {
    for (int k = 0; k < E::dimension; ++k) J.col(k) += dN[i][k] * X_e.col(i);
  }
  return J;
}

// Rest measure per reference measure: det J (signed) where J is square; in a higher dimension the length of the tangent
// of an edge or of the cross product of the two tangents of a surface.
template <int D, int Dim>
double measure_ratio(const Eigen::Matrix<double, D, Dim>& J) {
  if constexpr (D == Dim) {
    return J.determinant();
  } else if constexpr (Dim == 2) {
    return J.col(0).cross(J.col(1)).norm();
  } else {
    return J.norm();
  }
}

// Length [m], area [m^2] or volume [m^3] by the given rule of E; negative for an element that is inside out.
template <class E, int D, class Rule>
double measure(const Eigen::Matrix<double, D, E::nodes>& X_e, const Rule& rule) {
  double sum = 0;
  for (const auto& [xi, weight] : rule) sum += weight * measure_ratio(jacobian<E>(X_e, xi));
  return sum;
}

// Longest side of the bounding box [m].
inline double bounding_size(const Eigen::MatrixXd& X) {
  return (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).maxCoeff();
}

}  // namespace sim
