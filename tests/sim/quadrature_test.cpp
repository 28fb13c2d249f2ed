// Quadrature of every element: monomials, mass matrices, nodal loads.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "sim/element/list.h"

namespace sim {
namespace {

template <class E>
constexpr bool is_simplex = E::corners == E::dimension + 1;

double factorial(int n) {
  return std::tgamma(n + 1.0);
}

// Integral of x^a y^b z^c over the reference element: a! b! c!/(a + b + c + d)! on a simplex, products of
// 2/(a + 1) (even a) on [-1,1]^d.
template <class E>
double exact_monomial(const std::array<int, E::dimension>& power) {
  double product = 1;
  int sum = 0;
  for (const int p : power) {
    product *= is_simplex<E> && E::dimension > 1 ? factorial(p) : (p % 2 == 0 ? 2.0 / (p + 1) : 0.0);
    sum += p;
  }
  return is_simplex<E> && E::dimension > 1 ? product / factorial(sum + E::dimension) : product;
}

// Largest error of the rule over all monomials up to the degree (total degree on simplices, per variable else).
template <class E, class Rule>
double worst_monomial_error(const Rule& rule, int degree) {
  double worst = 0;
  std::array<int, E::dimension> power{};
  const int side = degree + 1;
  for (int code = 0; code < std::pow(side, E::dimension); ++code) {
    int rest = code, total = 0;
    for (int& p : power) {
      p = rest % side;
      rest /= side;
      total += p;
    }
    if (is_simplex<E> && total > degree) continue;
    double sum = 0;
    for (const auto& [xi, weight] : rule) {
      double term = weight;
      for (int k = 0; k < E::dimension; ++k) term *= std::pow(xi[k], power[k]);
      sum += term;
    }
    worst = std::max(worst, std::abs(sum - exact_monomial<E>(power)));
  }
  return worst;
}

template <class E, class Rule>
void expect_interior_and_positive(const Rule& rule) {
  for (const auto& [xi, weight] : rule) {
    EXPECT_GT(weight, 0);
    double sum = 0;
    for (const double x : xi) {
      EXPECT_GT(x, is_simplex<E> && E::dimension > 1 ? 0.0 : -1.0);
      EXPECT_LT(x, 1.0);
      sum += x;
    }
    if (is_simplex<E>) {
      EXPECT_LT(sum, 1.0);
    }
  }
}

template <class E>
void expect_rules(int points, int degree, int mass_points, int mass_degree) {
  SCOPED_TRACE(E::name);
  EXPECT_EQ(E::rule.size(), static_cast<std::size_t>(points));
  EXPECT_EQ(E::mass_rule.size(), static_cast<std::size_t>(mass_points));
  EXPECT_LT(worst_monomial_error<E>(E::rule, degree), 2e-15);
  EXPECT_LT(worst_monomial_error<E>(E::mass_rule, mass_degree), 2e-15);
  EXPECT_GT(worst_monomial_error<E>(E::rule, degree + 2), 1e-6);  // and not by accident better than its name
  expect_interior_and_positive<E>(E::rule);
  expect_interior_and_positive<E>(E::mass_rule);
}

TEST(Quadrature, IsExactToItsDegree) {
  expect_rules<Tri3>(1, 1, 3, 2);
  expect_rules<Tri6>(3, 2, 6, 4);
  expect_rules<Quad4>(4, 3, 4, 3);
  expect_rules<Tet4>(1, 1, 4, 2);
  expect_rules<Tet10>(4, 2, 14, 5);
  expect_rules<Hex8>(8, 3, 8, 3);
  EXPECT_LT(worst_monomial_error<Edge2>(Edge2::rule, 1), 2e-15);
  EXPECT_LT(worst_monomial_error<Edge3>(Edge3::rule, 5), 2e-15);
}

// int N_i N_j over the reference element by the mass rule.
template <class E>
Eigen::MatrixXd mass() {
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(E::nodes, E::nodes);
  for (const auto& [xi, weight] : E::mass_rule) {
    const auto N = E::N(xi);
    const Eigen::Map<const Eigen::Matrix<double, E::nodes, 1>> n(N.data());
    M += weight * n * n.transpose();
  }
  return M;
}

// Closed forms of the consistent mass matrix, in parts of the reference measure.
TEST(Quadrature, MassMatricesAreTheKnownOnes) {
  const double area = 1.0 / 2, volume = 1.0 / 6;
  EXPECT_NEAR(mass<Tri3>()(0, 0), area / 6, 1e-15);
  EXPECT_NEAR(mass<Tri3>()(0, 1), area / 12, 1e-15);
  EXPECT_NEAR(mass<Tet4>()(0, 0), volume / 10, 1e-15);
  EXPECT_NEAR(mass<Tet4>()(0, 1), volume / 20, 1e-15);
  const auto tri6 = mass<Tri6>();
  EXPECT_NEAR(tri6(0, 0), 6 * area / 180, 1e-15);
  EXPECT_NEAR(tri6(0, 1), -1 * area / 180, 1e-15);
  EXPECT_NEAR(tri6(0, 3), 0, 1e-15);                // the edge's own end
  EXPECT_NEAR(tri6(0, 4), -4 * area / 180, 1e-15);  // the opposite edge
  EXPECT_NEAR(tri6(3, 3), 32 * area / 180, 1e-15);
  EXPECT_NEAR(tri6(3, 4), 16 * area / 180, 1e-15);
  const auto tet10 = mass<Tet10>();
  EXPECT_NEAR(tet10(0, 0), 6 * volume / 420, 1e-15);
  EXPECT_NEAR(tet10(0, 1), volume / 420, 1e-15);
  EXPECT_NEAR(tet10(0, 4), -4 * volume / 420, 1e-15);
  EXPECT_NEAR(tet10(0, 5), -6 * volume / 420, 1e-15);
  EXPECT_NEAR(tet10(4, 4), 32 * volume / 420, 1e-15);
  EXPECT_NEAR(tet10(4, 5), 16 * volume / 420, 1e-15);
  EXPECT_NEAR(tet10(4, 9), 8 * volume / 420, 1e-15);  // opposite edges
  EXPECT_NEAR(mass<Quad4>()(0, 2), 4.0 / 36, 1e-15);
  EXPECT_NEAR(mass<Hex8>()(0, 6), 8.0 / 216, 1e-15);
}

// Shares of a constant traction at the nodes of a facet.
template <class F>
void expect_load(std::vector<double> shares, double reference_measure) {
  std::vector<double> load(F::nodes, 0);
  for (const auto& [xi, weight] : F::rule) {
    const auto N = F::N(xi);
    for (int i = 0; i < F::nodes; ++i) load[i] += weight * N[i];
  }
  for (int i = 0; i < F::nodes; ++i) EXPECT_NEAR(load[i] / reference_measure, shares[i], 1e-15);
}

TEST(Quadrature, ConstantTractionGivesTheKnownNodalLoads) {
  expect_load<Edge2>({0.5, 0.5}, 2);
  expect_load<Edge3>({1.0 / 6, 1.0 / 6, 2.0 / 3}, 2);
  expect_load<Tri3>({1.0 / 3, 1.0 / 3, 1.0 / 3}, 0.5);
  expect_load<Tri6>({0, 0, 0, 1.0 / 3, 1.0 / 3, 1.0 / 3}, 0.5);
  expect_load<Quad4>({0.25, 0.25, 0.25, 0.25}, 4);
}

}  // namespace
}  // namespace sim
