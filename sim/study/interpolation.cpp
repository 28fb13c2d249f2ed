#include "sim/study/interpolation.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "sim/mesh/geometry.h"
#include "sim/residual/rule.h"

namespace sim {
namespace {

constexpr int line_points = 12;    // degree 23 along each direction
constexpr int lattice_cells = 40;  // along an edge

template <class E>
constexpr bool is_triangle = E::corners == 3;

// Products of Gauss's rule on the square; on the triangle by r = (1 + t)/2, s = (1 - r)(1 + t')/2, ds dr = (1 - r)/4
// dt' dt.
template <class E>
std::vector<QuadraturePoint<2>> fine_rule() {
  const residual::Rule line = residual::gauss_legendre(line_points);
  std::vector<QuadraturePoint<2>> rule;
  for (int i = 0; i < line_points; ++i)
    for (int j = 0; j < line_points; ++j) {
      const auto t = static_cast<double>(line.t[i]), other = static_cast<double>(line.t[j]);
      const auto weight = static_cast<double>(line.weight[i] * line.weight[j]);
      const double r = (1 + t) / 2, s = (1 - r) * (1 + other) / 2;
      if (is_triangle<E>) {
        rule.push_back({{r, s}, weight * (1 - r) / 4});
      } else {
        rule.push_back({{t, other}, weight});
      }
    }
  return rule;
}

// Points at equal distances, corners and edges among them.
template <class E>
std::vector<std::array<double, 2>> lattice() {
  std::vector<std::array<double, 2>> points;
  for (int i = 0; i <= lattice_cells; ++i)
    for (int j = 0; j <= (is_triangle<E> ? lattice_cells - i : lattice_cells); ++j) {
      const double r = double(i) / lattice_cells, s = double(j) / lattice_cells;
      points.push_back(is_triangle<E> ? std::array{r, s} : std::array{2 * r - 1, 2 * s - 1});
    }
  return points;
}

// e^2 and |grad e|^2 over one element are added, the largest |e| is kept.
template <class E>
class ElementError {
 public:
  explicit ElementError(const PlaneFunction& u) : u_(u) {}

  void add(const ElementX<E, 2>& X_e, InterpolationError& sum) const {
    Eigen::Matrix<double, 1, E::nodes> values;
    for (int i = 0; i < E::nodes; ++i) values[i] = u_.value(X_e.col(i));
    for (const auto& [xi, weight] : rule_) {
      const Position<2> X = position<E, 2>(X_e, xi);
      const Jacobian<E, 2> J = jacobian<E, 2>(X_e, xi);
      const double w = weight * J.determinant(), e = interpolate(values, xi) - u_.value(X);
      // grad = dN/dxi J^-1
      Eigen::RowVector2d slope = Eigen::RowVector2d::Zero();
      const auto dN = E::dN(xi);
      for (int i = 0; i < E::nodes; ++i) slope += values[i] * Eigen::RowVector2d(dN[i][0], dN[i][1]);
      sum.L2 += w * e * e;
      sum.H1_seminorm += w * (slope * J.inverse() - u_.gradient(X).transpose()).squaredNorm();
    }
    for (const auto& xi : lattice_)
      sum.max = std::max(sum.max, std::abs(interpolate(values, xi) - u_.value(position<E, 2>(X_e, xi))));
  }

 private:
  static double interpolate(const Eigen::Matrix<double, 1, E::nodes>& values, const std::array<double, 2>& xi) {
    const auto N = E::N(xi);
    double sum = 0;
    for (int i = 0; i < E::nodes; ++i) sum += values[i] * N[i];
    return sum;
  }

  const PlaneFunction& u_;
  std::vector<QuadraturePoint<2>> rule_ = fine_rule<E>();
  std::vector<std::array<double, 2>> lattice_ = lattice<E>();
};

}  // namespace

InterpolationError interpolation_error(const Mesh& mesh, const PlaneFunction& u) {
  InterpolationError sum;
  visit_element(mesh.kind, [&]<class E>(std::type_identity<E>) {
    if constexpr (E::dimension == 2) {
      const ElementError<E> error(u);
      for (int e = 0; e < mesh.element_count(); ++e) error.add(gather<E, 2>(mesh.X, mesh.elements.col(e).data()), sum);
    }
  });
  return {std::sqrt(sum.L2), std::sqrt(sum.H1_seminorm), sum.max};
}

}  // namespace sim
