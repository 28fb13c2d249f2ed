// Shape functions, quadrature and the tables of every element.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "sim/element/list.h"
#include "sim/mesh/geometry.h"
#include "sim/mesh/subdivide.h"

namespace sim {
namespace {

template <class E>
constexpr bool simplex = E::corners == E::dimension + 1;

template <class E>
Eigen::Matrix<double, E::dimension, E::nodes> reference_nodes() {
  Eigen::Matrix<double, E::dimension, E::nodes> X;
  const auto xi = node_xi<E>();
  for (int i = 0; i < E::nodes; ++i) {
    for (int k = 0; k < E::dimension; ++k) X(k, i) = xi[i][k];
  }
  return X;
}

// Points inside the reference element, and some outside: the formulas hold everywhere.
template <class E>
std::vector<std::array<double, E::dimension>> random_points(int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(simplex<E> ? 0.0 : -1.0, 1.0);
  std::vector<std::array<double, E::dimension>> points(count);
  for (auto& point : points) {
    for (double& x : point) x = uniform(random);
  }
  return points;
}

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
    product *= simplex<E> && E::dimension > 1 ? factorial(p) : (p % 2 == 0 ? 2.0 / (p + 1) : 0.0);
    sum += p;
  }
  return simplex<E> && E::dimension > 1 ? product / factorial(sum + E::dimension) : product;
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
    if (simplex<E> && total > degree) continue;
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
      EXPECT_GT(x, simplex<E> && E::dimension > 1 ? 0.0 : -1.0);
      EXPECT_LT(x, 1.0);
      sum += x;
    }
    if (simplex<E>) {
      EXPECT_LT(sum, 1.0);
    }
  }
}

template <class E>
class ElementTest : public testing::Test {};
using AllElements = testing::Types<Edge2, Edge3, Tri3, Tri6, Quad4, Tet4, Tet10, Hex8>;
TYPED_TEST_SUITE(ElementTest, AllElements);

TYPED_TEST(ElementTest, ShapeFunctionsAreOneAtTheirNodeAndZeroAtTheOthers) {
  using E = TypeParam;
  const auto xi = node_xi<E>();
  for (int j = 0; j < E::nodes; ++j) {
    const auto N = E::N(xi[j]);
    for (int i = 0; i < E::nodes; ++i) EXPECT_DOUBLE_EQ(N[i], i == j ? 1.0 : 0.0) << i << " at " << j;
  }
}

TYPED_TEST(ElementTest, ShapeFunctionsReproduceConstantsAndLines) {
  using E = TypeParam;
  const auto X = reference_nodes<E>();
  for (const auto& xi : random_points<E>(20)) {
    const auto N = E::N(xi);
    const auto dN = E::dN(xi);
    Eigen::Matrix<double, E::dimension, 1> x = x.Zero(), at;
    Eigen::Matrix<double, E::dimension, E::dimension> J = J.Zero();
    double sum = 0;
    for (int i = 0; i < E::nodes; ++i) {
      sum += N[i];
      x += N[i] * X.col(i);
      for (int k = 0; k < E::dimension; ++k) J.col(k) += dN[i][k] * X.col(i);
    }
    for (int k = 0; k < E::dimension; ++k) at[k] = xi[k];
    EXPECT_NEAR(sum, 1, 1e-15);
    EXPECT_LT((x - at).norm(), 1e-15);
    EXPECT_LT((J - J.Identity()).norm(), 1e-14);
  }
}

TYPED_TEST(ElementTest, GradientsMatchCentralDifferencesAndSumToZero) {
  using E = TypeParam;
  const double step = 1e-5;  // the shape functions are at most cubic: error step^2/6 times the third derivative
  for (const auto& xi : random_points<E>(20)) {
    const auto dN = E::dN(xi);
    for (int k = 0; k < E::dimension; ++k) {
      auto before = xi, after = xi;
      before[k] -= step;
      after[k] += step;
      const auto low = E::N(before), high = E::N(after);
      double sum = 0;
      for (int i = 0; i < E::nodes; ++i) {
        EXPECT_NEAR(dN[i][k], (high[i] - low[i]) / (2 * step), 1e-9);
        sum += dN[i][k];
      }
      EXPECT_NEAR(sum, 0, 1e-14);
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

// On the reference element the facets are flat, so their normal is constant.
template <class E>
void expect_outward_facets() {
  SCOPED_TRACE(E::name);
  using F = typename E::Facet;
  const Eigen::MatrixXd X = reference_nodes<E>();
  const Eigen::VectorXd centre = X.leftCols(E::corners).rowwise().mean();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(E::dimension);
  for (std::size_t f = 0; f < E::facets.size(); f += F::nodes) {
    const auto X_f = gather<F, E::dimension>(X, &E::facets[f]);
    const auto J = jacobian<F>(X_f, F::rule[0].xi);
    Eigen::VectorXd normal(E::dimension);
    if constexpr (E::dimension == 2) {
      normal << J(1, 0), -J(0, 0);
    } else {
      normal = Eigen::Vector3d(J.col(0)).cross(Eigen::Vector3d(J.col(1)));
    }
    EXPECT_GT(normal.dot(X_f.leftCols(F::corners).rowwise().mean() - centre), 0.1) << "facet node " << f;
    for (const auto& [xi, weight] : F::rule) sum += weight * normal;
    // A middle node of the facet lies half-way between its ends: facet and edge tables agree.
    if constexpr (E::order == 2) {
      for (const auto& [a, b, m] : F::edges) EXPECT_EQ((X_f.col(a) + X_f.col(b)) / 2, X_f.col(m));
    }
  }
  EXPECT_LT(sum.norm(), 1e-15);  // closed surface: int n dA = 0
}

TEST(Element, FacetsAreClosedAndPointOutward) {
  for_each_type(Elements{}, []<class E>(std::type_identity<E>) { expect_outward_facets<E>(); });
}

TEST(Element, MirroredOrderTurnsItInsideOut) {
  for_each_type(Elements{}, []<class E>(std::type_identity<E>) {
    const Eigen::MatrixXd X = reference_nodes<E>();
    const double reference = measure<E>(reference_nodes<E>(), E::mass_rule);
    EXPECT_GT(reference, 0);
    EXPECT_NEAR(measure<E>(gather<E, E::dimension>(X, E::mirrored.data()), E::mass_rule), -reference, 1e-14) << E::name;
    for (const auto& xi : E::mass_rule) {
      EXPECT_LT(measure_ratio(jacobian<E>(gather<E, E::dimension>(X, E::mirrored.data()), xi.xi)), 0) << E::name;
    }
  });
}

TEST(Element, InfoAgreesWithTheList) {
  for_each_type(Elements{}, []<class E>(std::type_identity<E>) {
    const ElementInfo* found = find_element(E::name);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found, &info(E::kind));
    EXPECT_EQ(found->kind, E::kind);
    EXPECT_EQ(found->nodes, E::nodes);
    EXPECT_EQ(found->dimension, E::dimension);
    EXPECT_EQ(found->facet_nodes, E::Facet::nodes);
    EXPECT_EQ(found->facets.size() % found->facet_nodes, 0u);
  });
  EXPECT_EQ(find_element("tet5"), nullptr);
  EXPECT_EQ(find_element(""), nullptr);
  EXPECT_EQ(info(ElementKind::tet10).facets.size(), 24u);
  EXPECT_EQ(info(ElementKind::hex8).edges.size(), 12u);
}

TEST(ElementTable, PartnersDifferByTheirMiddleNodesOnly) {
  for (const ElementInfo& element : elements()) {
    SCOPED_TRACE(element.name);
    const ElementInfo& linear = info(element.linear);
    EXPECT_EQ(linear.order, 1);
    EXPECT_EQ(linear.dimension, element.dimension);
    EXPECT_EQ(linear.nodes, element.corners);
    EXPECT_EQ(element.order == 1, element.linear == element.kind);
    if (!element.quadratic) continue;
    const ElementInfo& quadratic = info(*element.quadratic);
    EXPECT_EQ(quadratic.order, 2);
    EXPECT_EQ(quadratic.linear, element.linear);
    EXPECT_EQ(quadratic.nodes, element.corners + static_cast<int>(element.edges.size()));
  }
  EXPECT_EQ(find_element("tri3")->quadratic, ElementKind::tri6);
  EXPECT_EQ(find_element("tet4")->quadratic, ElementKind::tet10);
  EXPECT_FALSE(find_element("hex8")->quadratic.has_value());
}

// The VTK User's Guide, "VTK file formats"; the Gmsh reference manual, "MSH file format".
TEST(ElementTable, HasTheNumbersOfVtkAndGmsh) {
  struct Numbers {
    const char* name;
    int vtk, gmsh;
  };
  for (const Numbers& is : {Numbers{"tri3", 5, 2}, Numbers{"tri6", 22, 9}, Numbers{"quad4", 9, 3},
                            Numbers{"tet4", 10, 4}, Numbers{"tet10", 24, 11}, Numbers{"hex8", 12, 5}}) {
    EXPECT_EQ(find_element(is.name)->vtk, is.vtk) << is.name;
    EXPECT_EQ(find_element(is.name)->gmsh, is.gmsh) << is.name;
  }
}

TEST(ElementTable, IsListedAsMessagesDo) {
  EXPECT_EQ(element_list([](const ElementInfo& e) { return e.dimension == 2; }), "tri3, tri6 or quad4");
  EXPECT_EQ(element_list([](const ElementInfo& e) { return e.membrane; }), "tri3 or tri6");
  EXPECT_EQ(element_list([](const ElementInfo& e) { return e.corners == 8; }), "hex8");
}

}  // namespace
}  // namespace sim
