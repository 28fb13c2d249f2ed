// The map of an element from its reference coordinates into space, at rest, and sizes that follow from it.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>

#include "sim/element/element.h"
#include "sim/mesh/mesh.h"

namespace sim {

// Nodal positions of one element (or facet) E, dimension x nodes [m], without heap memory.
template <class E>
using ElementX = Eigen::Matrix<double, Eigen::Dynamic, E::nodes, Eigen::ColMajor, 3, E::nodes>;
// A position, 2 or 3 numbers [m].
using Position = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3, 1>;
// dX/dxi, dimension x reference dimension.
template <class E>
using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, E::dimension, Eigen::ColMajor, 3, E::dimension>;

// `nodes` points to the E::nodes node numbers.
template <class E>
ElementX<E> gather(const Eigen::MatrixXd& X, const int* nodes) {
  ElementX<E> X_e(X.rows(), E::nodes);
  for (int i = 0; i < E::nodes; ++i) X_e.col(i) = X.col(nodes[i]);
  return X_e;
}

// X(xi) = sum_i X_i N_i(xi)
template <class E>
Position position(const ElementX<E>& X_e, const std::array<double, E::dimension>& xi) {
  const auto N = E::N(xi);
  return X_e * Eigen::Map<const Eigen::Matrix<double, E::nodes, 1>>(N.data());
}

// dX/dxi = sum_i X_i dN_i/dxi
template <class E>
Jacobian<E> jacobian(const ElementX<E>& X_e, const std::array<double, E::dimension>& xi) {
  const auto dN = E::dN(xi);
  Jacobian<E> J = Jacobian<E>::Zero(X_e.rows(), E::dimension);
  for (int i = 0; i < E::nodes; ++i) {
    for (int k = 0; k < E::dimension; ++k) J.col(k) += dN[i][k] * X_e.col(i);
  }
  return J;
}

// Rest measure per reference measure: det J (signed) where J is square; in a higher dimension the length of the tangent
// of an edge or of the cross product of the two tangents of a surface.
template <class E>
double measure_ratio(const Jacobian<E>& J) {
  if (J.rows() == E::dimension) return Eigen::Matrix<double, E::dimension, E::dimension>(J).determinant();
  if constexpr (E::dimension == 2) return Eigen::Vector3d(J.col(0)).cross(Eigen::Vector3d(J.col(1))).norm();
  return J.norm();
}

// Length [m], area [m^2] or volume [m^3] by the given rule of E; negative for an element that is inside out.
template <class E, class Rule>
double measure(const ElementX<E>& X_e, const Rule& rule) {
  double sum = 0;
  for (const auto& [xi, weight] : rule) sum += weight * measure_ratio<E>(jacobian<E>(X_e, xi));
  return sum;
}

// Longest side of the bounding box [m].
inline double bounding_size(const Eigen::MatrixXd& X) {
  return (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).maxCoeff();
}

}  // namespace sim
