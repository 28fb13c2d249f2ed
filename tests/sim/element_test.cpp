// Shape functions and the tables of every element.
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
