// The volume between a facet and the origin, by which pressure does work, and its derivatives: polynomials in the
// facet's nodes, so that the integrals over the reference facet are made once. Facets as a mesh has them: outward.
//   in space  V = 1/3 int x . (x,1 x x,2)  = sum_abc A_abc det(x_a, x_b, x_c)
//   plane     V = 1/2 int det(x, x,1)      = sum_ab  A_ab  det(x_a, x_b)     (per thickness)
// A is the antisymmetric part of the integrals of N_a N_b,1 (N_c,2). Over a closed surface the gradient of V is the
// force of a unit pressure from inside, and its second derivative that force's exact tangent.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

#include "sim/element/edge2.h"
#include "sim/element/edge3.h"
#include "sim/element/quad4.h"
#include "sim/element/tri3.h"
#include "sim/element/tri6.h"

namespace sim {

// The rule that integrates N N,1 N,2 of a facet exactly: degree 4 for six nodes, 3 for three along an edge.
template <class Facet>
constexpr auto enclosing_rule() {
  if constexpr (Facet::dimension == 1)
    return line_3;
  else if constexpr (Facet::corners == 4)
    return square_4;
  else
    return triangle_6;
}

// int N_a N_b,1 (N_c,2), c = 0 alone in the plane
template <class Facet, int D>
constexpr auto shape_integrals() {
  constexpr int n = Facet::nodes;
  std::array<std::array<std::array<double, n>, n>, n> T{};
  for (const auto& q : enclosing_rule<Facet>()) {
    const auto N = Facet::N(q.xi);
    const auto dN = Facet::dN(q.xi);
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        for (int c = 0; c < (D == 3 ? n : 1); ++c)
          T[a][b][c] += q.weight * N[a] * dN[b][0] * (D == 3 ? dN[c][D - 2] : 1);
  }
  return T;
}

template <class Facet, int D>
struct Enclosed {
  static_assert(Facet::dimension == D - 1);
  static constexpr int n = Facet::nodes;
  using Nodes = Eigen::Matrix<double, D, n>;
  using Block = Eigen::Matrix<double, D, D>;

  static constexpr auto T = shape_integrals<Facet, D>();

  static constexpr double A(int a, int b, int c) {
    if constexpr (D == 2)
      return (T[a][b][0] - T[b][a][0]) / 4;
    else
      return (T[a][b][c] + T[b][c][a] + T[c][a][b] - T[a][c][b] - T[b][a][c] - T[c][b][a]) / 18;
  }

  // dV/dx_a
  static Nodes gradient(const Nodes& x) {
    Nodes g = Nodes::Zero();
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) {
        if constexpr (D == 2)
          g.col(a) += 2 * A(a, b, 0) * Eigen::Vector2d(x(1, b), -x(0, b));
        else
          for (int c = 0; c < n; ++c) g.col(a) += 3 * A(a, b, c) * x.col(b).cross(x.col(c));
      }
    return g;
  }

  static double volume(const Nodes& x) { return gradient(x).cwiseProduct(x).sum() / D; }

  // d2V/dx_a dx_b
  static Block hessian(const Nodes& x, int a, int b) {
    Block H = Block::Zero();
    if constexpr (D == 2) {
      H << 0, 2 * A(a, b, 0), -2 * A(a, b, 0), 0;
    } else {
      Eigen::Vector3d u = Eigen::Vector3d::Zero();  // H dx_b = dx_b x u
      for (int c = 0; c < n; ++c) u += 6 * A(a, b, c) * x.col(c);
      H << 0, u[2], -u[1], -u[2], 0, u[0], u[1], -u[0], 0;
    }
    return H;
  }

  // int N_a n dA: what a unit pressure from inside does to each node, whether or not the surface is closed.
  static Nodes pressed(const Nodes& x) {
    Nodes f = Nodes::Zero();
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) {
        if constexpr (D == 2)
          f.col(a) += T[a][b][0] * Eigen::Vector2d(x(1, b), -x(0, b));
        else
          for (int c = 0; c < n; ++c) f.col(a) += T[a][b][c] * x.col(b).cross(x.col(c));
      }
    return f;
  }
};

}  // namespace sim
