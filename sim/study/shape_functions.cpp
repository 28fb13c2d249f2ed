#include "sim/study/shape_functions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/mesh/geometry.h"

namespace sim {

namespace {

constexpr int lattice = 40;  // intervals along an edge, where the largest error is looked for

// Calls f(std::type_identity<E>{}) for a plane mesh.
template <class F>
auto visit_plane(const Mesh& mesh, const F& f) {
  return visit_mesh(mesh, [&]<class E, int D>(std::type_identity<E> element, std::integral_constant<int, D>) {
    if constexpr (E::dimension == 2) return f(element);
    return decltype(f(std::type_identity<Tri3>{})){};
  });
}

bool is_quad(const Mesh& mesh) {
  return mesh.kind == ElementKind::quad4;
}

// Reference coordinates of (i, j) on a lattice of n intervals; of triangles those with i + j <= n.
Eigen::Vector2d lattice_point(bool quad, int i, int j, int n) {
  const Eigen::Vector2d share(double(i) / n, double(j) / n);
  return quad ? Eigen::Vector2d(2 * share - Eigen::Vector2d::Ones()) : share;
}

// How far outside the element (negative: inside): the largest distance from a side in reference coordinates.
double outside(bool quad, const Eigen::Vector2d& xi) {
  if (quad) return xi.cwiseAbs().maxCoeff() - 1;
  return std::max({-xi.x(), -xi.y(), xi.x() + xi.y() - 1});
}

Eigen::Vector2d gradient_of_u(const Eigen::Vector2d& X) {
  constexpr double pi = std::numbers::pi;
  return Eigen::Vector2d(pi * std::cos(pi * X.x()), std::sin(pi * X.x())) * std::exp(X.y());
}

// u less its interpolant, and the gradient of that.
struct Gap {
  double value;
  Eigen::Vector2d gradient;
  Gap(const Mesh& mesh, const PointOfElement& at) {
    const ShapeValues v = shape_values(mesh, at);
    value = interpolated(v.X);
    gradient = gradient_of_u(v.X);
    for (Eigen::Index a = 0; a < v.N.size(); ++a) {
      const double nodal = interpolated(mesh.X.col(mesh.elements(a, at.element)));
      value -= nodal * v.N[a];
      gradient -= nodal * v.dN_dX.row(a).transpose();
    }
  }
};

// Points and weights on [0,1] of degree 13 [Abramowitz & Stegun 1964, 25.4.29, n = 7].
constexpr double gauss_x[] = {0, 0.405845151377397, 0.741531185599394, 0.949107912342759};
constexpr double gauss_w[] = {0.417959183673469, 0.381830050505119, 0.279705391489277, 0.129484966168870};

template <class F>
void for_each_gauss_point(const F& f) {
  for (int k = -3; k <= 3; ++k) f(0.5 + 0.5 * (k < 0 ? -gauss_x[-k] : gauss_x[k]), 0.5 * gauss_w[std::abs(k)]);
}

double area_ratio(const Mesh& mesh, const PointOfElement& at) {
  return visit_plane(mesh, [&]<class E>(std::type_identity<E>) {
    const auto X_e = gather<E, 2>(mesh.X, mesh.elements.col(at.element).data());
    return std::abs(jacobian<E, 2>(X_e, {at.xi.x(), at.xi.y()}).determinant());
  });
}

// Squares of the error and of its gradient over one element. A triangle is the square [0,1]^2 with one side drawn
// together: (r, s) = (p, q (1 - p)). [Duffy 1982]
void add_squares(const Mesh& mesh, int e, InterpolationError& sum) {
  const bool quad = is_quad(mesh);
  for_each_gauss_point([&](double p, double wp) {
    for_each_gauss_point([&](double q, double wq) {
      const PointOfElement at{e, quad ? Eigen::Vector2d(2 * p - 1, 2 * q - 1) : Eigen::Vector2d(p, q * (1 - p))};
      const Gap gap(mesh, at);
      const double w = wp * wq * area_ratio(mesh, at) * (quad ? 4 : 1 - p);
      sum.L2 += w * gap.value * gap.value;
      sum.H1_seminorm += w * gap.gradient.squaredNorm();
    });
  });
}

}  // namespace

double interpolated(const Eigen::Vector2d& X) {
  return std::sin(std::numbers::pi * X.x()) * std::exp(X.y());
}

ShapeValues shape_values(const Mesh& mesh, const PointOfElement& at) {
  return visit_plane(mesh, [&]<class E>(std::type_identity<E>) {
    const std::array<double, 2> xi = {at.xi.x(), at.xi.y()};
    const auto X_e = gather<E, 2>(mesh.X, mesh.elements.col(at.element).data());
    const auto N = E::N(xi);
    const auto dN = E::dN(xi);
    const Eigen::Matrix2d inverse = jacobian<E, 2>(X_e, xi).inverse();
    ShapeValues values{position<E, 2>(X_e, xi), Eigen::VectorXd(E::nodes), Eigen::MatrixXd(E::nodes, 2)};
    for (int a = 0; a < E::nodes; ++a) {
      values.N[a] = N[a];
      values.dN_dX.row(a) = Eigen::RowVector2d(dN[a][0], dN[a][1]) * inverse;
    }
    return values;
  });
}

// Newton's method for X(xi) = X in every element: exact at once on straight triangles, in a few steps on
// quadrilaterals.
PointOfElement find_point_of_element(const Mesh& mesh, const Eigen::Vector2d& X) {
  constexpr int steps = 8;
  PointOfElement best;
  double least = std::numeric_limits<double>::infinity();
  for (int e = 0; e < mesh.element_count(); ++e) {
    PointOfElement at{e, is_quad(mesh) ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(1.0 / 3, 1.0 / 3)};
    for (int k = 0; k < steps; ++k) {
      const auto step = visit_plane(mesh, [&]<class E>(std::type_identity<E>) -> Eigen::Vector2d {
        const std::array<double, 2> xi = {at.xi.x(), at.xi.y()};
        const auto X_e = gather<E, 2>(mesh.X, mesh.elements.col(e).data());
        return jacobian<E, 2>(X_e, xi).inverse() * (X - position<E, 2>(X_e, xi));
      });
      at.xi += step;
    }
    const double distance = outside(is_quad(mesh), at.xi);
    if (!(distance < least)) continue;
    least = distance;
    best = at;
  }
  return best;
}

std::vector<std::vector<PointOfElement>> facets_of_element(const Mesh& mesh, int element, int pieces) {
  const bool quad = is_quad(mesh);
  const auto at = [&](int i, int j) { return PointOfElement{element, lattice_point(quad, i, j, pieces)}; };
  std::vector<std::vector<PointOfElement>> facets;
  for (int i = 0; i < pieces; ++i)
    for (int j = 0; j < (quad ? pieces : pieces - i); ++j) {
      if (quad) {
        facets.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        continue;
      }
      facets.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      if (i + j + 1 < pieces) facets.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return facets;
}

InterpolationError interpolation_error(const Mesh& mesh) {
  InterpolationError error;
  const bool quad = is_quad(mesh);
  for (int e = 0; e < mesh.element_count(); ++e) {
    add_squares(mesh, e, error);
    for (int i = 0; i <= lattice; ++i)
      for (int j = 0; j <= (quad ? lattice : lattice - i); ++j)
        error.max = std::max(error.max, std::abs(Gap(mesh, {e, lattice_point(quad, i, j, lattice)}).value));
  }
  error.L2 = std::sqrt(error.L2);
  error.H1_seminorm = std::sqrt(error.H1_seminorm);
  return error;
}

}  // namespace sim
