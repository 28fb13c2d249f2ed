// Refinement and the step to quadratic elements: measures, counts, conformity, groups, curved shapes, quality.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sim/mesh/quadratic.h"
#include "sim/mesh/refine.h"
#include "tests/sim/mesh_support.h"

namespace sim::test {
namespace {

class RefineKind : public testing::TestWithParam<ElementKind> {};
INSTANTIATE_TEST_SUITE_P(Mesh, RefineKind, testing::ValuesIn(all_kinds), kind_name);

TEST_P(RefineKind, KeepsTheMeasureAndMultipliesTheCounts) {
  const Mesh coarse = bent(sample(GetParam()));
  const Mesh fine = refine(coarse);
  const int factor = info(GetParam()).dimension == 2 ? 4 : 8;
  EXPECT_EQ(fine.element_count(), factor * coarse.element_count());
  EXPECT_EQ(fine.kind, coarse.kind);
  EXPECT_EQ(euler_characteristic(fine), 1);
  EXPECT_EQ(boundary(fine).non_manifold, 0);
  EXPECT_EQ(boundary_facets(fine).cols(), factor / 2 * boundary_facets(coarse).cols());
  // Every child's map is the parent's, so also curved shapes keep their measure.
  const double exact = total_measure(coarse);
  EXPECT_NEAR(total_measure(fine), exact, 1e-13);
  EXPECT_NEAR(enclosed_measure(fine), exact, 1e-13);
  EXPECT_EQ(fine.X.leftCols(coarse.node_count()), coarse.X);
}

TEST_P(RefineKind, ChildrenLieInTheirParentWithEqualShares) {
  const Mesh coarse = sample(GetParam());  // affine: every child of a simplex or a box has an equal share
  const Mesh fine = refine(coarse);
  visit_mesh(coarse, [&]<class E, int D>(std::type_identity<E>, std::integral_constant<int, D>) {
    const int factor = E::dimension == 2 ? 4 : 8;
    for (int e = 0; e < coarse.element_count(); ++e) {
      const double parent = measure<E>(gather<E, D>(coarse.X, coarse.elements.col(e).data()), E::mass_rule);
      for (int c = 0; c < factor; ++c) {
        const double child = measure<E>(gather<E, D>(fine.X, fine.elements.col(factor * e + c).data()), E::mass_rule);
        EXPECT_NEAR(child, parent / factor, 1e-14 * parent);
      }
    }
  });
}

TEST_P(RefineKind, GroupsAreCarried) {
  Mesh coarse = bent(sample(GetParam()));
  coarse.groups.push_back({"some", {}, {1, 3}, {}});
  for (const int e : {1, 3}) {
    auto& nodes = coarse.groups.back().nodes;
    nodes.insert(nodes.end(), coarse.elements.col(e).begin(), coarse.elements.col(e).end());
  }
  const Mesh fine = refine(coarse);
  ASSERT_EQ(fine.groups.size(), coarse.groups.size());
  const int factor = info(GetParam()).dimension == 2 ? 4 : 8;
  for (std::size_t g = 0; g + 1 < coarse.groups.size(); ++g) {
    const Group &before = coarse.groups[g], &after = fine.groups[g];
    EXPECT_EQ(after.facets.cols(), factor / 2 * before.facets.cols()) << after.name;
    EXPECT_NEAR(facet_measure(fine, after.facets), facet_measure(coarse, before.facets),
                info(GetParam()).order == 2 || factor == 8 ? 2e-3 : 1e-14)  // curved: not a polynomial, by quadrature
        << after.name;
    const std::set<int> of_facets(after.facets.reshaped().begin(), after.facets.reshaped().end());
    EXPECT_EQ(std::vector<int>(of_facets.begin(), of_facets.end()), after.nodes) << after.name;
  }
  std::set<int> of_elements;
  std::vector<int> children;
  for (const int e : {1, 3}) {
    for (int c = 0; c < factor; ++c) children.push_back(factor * e + c);
  }
  for (const int e : children) of_elements.insert(fine.elements.col(e).begin(), fine.elements.col(e).end());
  EXPECT_EQ(fine.groups.back().elements, children);
  EXPECT_EQ(fine.groups.back().nodes, std::vector<int>(of_elements.begin(), of_elements.end()));
}

// Refining an even grid gives the nodes of the grid with twice the cells.
TEST_P(RefineKind, AgreesWithTheFinerGrid) {
  const auto grid = [&](int n) {
    const bool plane = info(GetParam()).dimension == 2;
    const Mesh mesh = plane ? generate_rectangle({2, 1}, {2 * n, n}, {1, 1}, GetParam())
                            : generate_box({2, 1, 1}, {2 * n, n, n}, {1, 1, 1}, GetParam());
    return n == 1 ? refine(mesh) : mesh;
  };
  const auto sorted = [](const Mesh& mesh) {
    std::set<std::vector<double>> points;
    for (const auto& X : mesh.X.colwise()) points.insert({X.begin(), X.end()});
    return points;
  };
  EXPECT_EQ(sorted(grid(1)), sorted(grid(2)));
}

TEST_P(RefineKind, WorksOnOneElementAndOnMembranes) {
  Mesh one = sample(GetParam(), 1, 1, 1);
  one.elements = one.elements.leftCols(1).eval();
  one.groups.clear();
  EXPECT_NEAR(total_measure(refine(refine(one))), total_measure(one), 1e-14);
  if (info(GetParam()).dimension == 3 || GetParam() == ElementKind::quad4) return;
  const Mesh sheet = generate_sheet({1, 1}, {2, 2}, {1, 1}, GetParam());
  EXPECT_NEAR(total_measure(refine(sheet)), 1, 1e-14);
  EXPECT_EQ(refine(sheet).dimension(), 3);
}

// Volume over the cube of the longest edge, the smallest over all elements; 1/(6 sqrt 2) for a regular tetrahedron.
double worst_shape(const Mesh& mesh) {
  double worst = 1;
  for (const auto& e : mesh.elements.colwise()) {
    const auto X_e = gather<Tet4, 3>(mesh.X, e.data());
    double longest = 0;
    for (const auto& [a, b, middle] : Tet4::edges) longest = std::max(longest, (X_e.col(a) - X_e.col(b)).norm());
    worst = std::min(worst, measure<Tet4>(X_e, Tet4::rule) / std::pow(longest, 3));
  }
  return worst;
}

TEST(Refine, TetrahedraKeepTheirShape) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double worst = 1;
  for (int trial = 0; trial < 50; ++trial) {
    Mesh mesh;
    mesh.kind = ElementKind::tet4;
    mesh.elements = Eigen::Vector4i(0, 1, 2, 3);
    do {
      mesh.X = Eigen::MatrixXd::NullaryExpr(3, 4, [&] { return uniform(random); });
    } while (total_measure(mesh) < 0.05);
    const double before = worst_shape(mesh), once = worst_shape(refine(mesh));
    const double after = worst_shape(refine(refine(refine(mesh))));
    EXPECT_GE(once, 0.3 * before);
    worst = std::min(worst, after / before);
  }
  EXPECT_GE(worst, 0.25) << "three refinements";
  // Kuhn's tetrahedra fall into eight copies of themselves.
  const Mesh box = generate_box({1, 1, 1}, {1, 1, 1}, {1, 1, 1}, ElementKind::tet4);
  EXPECT_DOUBLE_EQ(worst_shape(refine(refine(box))), worst_shape(box));
}

// A quarter of a disc, one parabola for its arc.
TEST(Refine, CurvedEdgesStayOnTheParentsCurve) {
  Mesh mesh;
  mesh.kind = ElementKind::tri6;
  mesh.X.resize(2, 6);
  const double s = std::sqrt(0.5);
  mesh.X << 0, 1, 0, 0.5, s, 0, 0, 0, 1, 0, s, 0.5;
  mesh.elements.resize(6, 1);
  mesh.elements << 0, 1, 2, 3, 4, 5;
  const Mesh fine = refine(mesh);
  EXPECT_EQ(fine.node_count(), 15);
  // The parabola through (1,0), (s,s), (0,1) at a quarter: (3/8, 3/4, -1/8) of its ends and middle.
  const Eigen::Vector2d expected =
      0.375 * Eigen::Vector2d(1, 0) + 0.75 * Eigen::Vector2d(s, s) - 0.125 * Eigen::Vector2d(0, 1);
  double nearest = 1;
  for (const auto& X : fine.X.colwise()) nearest = std::min(nearest, (X - expected).norm());
  EXPECT_LT(nearest, 1e-15);
  EXPECT_NEAR(total_measure(fine), total_measure(mesh), 1e-15);
}

TEST(Quadratic, CountsAndGroups) {
  for (const auto& [linear, quadratic] :
       {std::pair{ElementKind::tri3, ElementKind::tri6}, std::pair{ElementKind::tet4, ElementKind::tet10}}) {
    const Mesh coarse = sample(linear, 4, 3, 2);
    std::set<std::pair<int, int>> edges;
    for (const auto& e : coarse.elements.colwise()) {
      for (const auto& [a, b, middle] : info(linear).edges) edges.insert(std::minmax(e[a], e[b]));
    }
    const Mesh mesh = to_quadratic(coarse);
    EXPECT_EQ(mesh.kind, quadratic);
    EXPECT_EQ(mesh.node_count(), coarse.node_count() + static_cast<int>(edges.size()));
    EXPECT_EQ(mesh.elements.topRows(info(linear).corners), coarse.elements);
    EXPECT_EQ(mesh.X.leftCols(coarse.node_count()), coarse.X);
    EXPECT_NEAR(total_measure(mesh), total_measure(coarse), 1e-13);
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
      EXPECT_EQ(mesh.groups[g].facets.rows(), info(quadratic).facet_nodes);
      EXPECT_EQ(mesh.groups[g].facets.cols(), coarse.groups[g].facets.cols());
      EXPECT_NEAR(facet_measure(mesh, mesh.groups[g].facets), facet_measure(coarse, coarse.groups[g].facets), 1e-14);
    }
    const Mesh again = to_quadratic(mesh);
    EXPECT_EQ(again.X, mesh.X);
    EXPECT_EQ(again.elements, mesh.elements);
  }
}

TEST(Quadratic, NodeGroupsTakeTheMiddlesBetweenTheirNodes) {
  Mesh mesh = generate_rectangle({2, 1}, {2, 1}, {1, 1}, ElementKind::tri3);  // nodes 0 1 2 / 3 4 5
  mesh.groups = {{"low", {0, 1}, {}, {}}, {"apart", {0, 2}, {}, {}}, {"one", {4}, {}, {}}, {"none", {}, {}, {}}};
  const Mesh quadratic = to_quadratic(mesh);
  const Group low = group(quadratic, "low");
  ASSERT_EQ(low.nodes.size(), 3u);
  EXPECT_EQ(quadratic.X.col(low.nodes[2]), Eigen::Vector2d(0.5, 0));
  EXPECT_EQ(group(quadratic, "apart").nodes, (std::vector<int>{0, 2}));
  EXPECT_EQ(group(quadratic, "one").nodes, std::vector<int>{4});
  EXPECT_TRUE(group(quadratic, "none").nodes.empty());
}

// The nodes of a facet group may also span an edge that crosses the body: its middle is not on the facets.
TEST(Quadratic, FacetGroupsTakeOnlyTheMiddlesOfTheirFacets) {
  Mesh mesh = generate_rectangle({1, 1}, {1, 1}, {1, 1}, ElementKind::tri3);
  Group sides{"sides", {0, 1, 2, 3}, {}, boundary_facets(mesh)};
  mesh.groups = {sides};
  const Mesh quadratic = to_quadratic(mesh);
  EXPECT_EQ(quadratic.node_count(), 9);
  EXPECT_EQ(quadratic.groups[0].nodes.size(), 8u);  // all but the middle of the diagonal
}

TEST(Quadratic, RefusesWhatHasNoQuadraticForm) {
  for (const ElementKind kind : {ElementKind::quad4, ElementKind::hex8}) {
    EXPECT_CONTAINS(error_of("mesh.element", [&] { to_quadratic(sample(kind)); }), info(kind).name);
  }
  Mesh mesh = sample(ElementKind::tri3);
  mesh.groups[1].facets(1, 0) = mesh.groups[1].facets(0, 0) == 0 ? mesh.node_count() - 1 : 0;  // not an edge
  EXPECT_CONTAINS(error_of("mesh", [&] { to_quadratic(mesh); }), "group \"right\"");
  EXPECT_CONTAINS(error_of("mesh", [&] { refine(mesh); }), "group \"right\"");
}

}  // namespace
}  // namespace sim::test
