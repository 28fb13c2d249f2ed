// Rectangles, boxes and sheets: sizes, conformity, groups, grading, bad input; boundaries and spatial order of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "sim/mesh/order.h"
#include "tests/sim/mesh_support.h"

namespace sim::test {
namespace {

class EveryKind : public testing::TestWithParam<ElementKind> {};
INSTANTIATE_TEST_SUITE_P(Mesh, EveryKind, testing::ValuesIn(all_kinds), kind_name);

TEST_P(EveryKind, MeasureIsExactForAnyCellsAndGrading) {
  const bool plane = info(GetParam()).dimension == 2;
  const double exact = plane ? 2 * 1.5 : 2 * 1.5 * 0.7;
  for (const auto [nx, ny, nz] : {std::array{1, 1, 1}, {3, 2, 2}, {4, 5, 3}, {2, 1, 7}}) {
    const Mesh mesh = sample(GetParam(), nx, ny, nz);
    EXPECT_NEAR(total_measure(mesh), exact, 1e-13 * exact);
    EXPECT_NEAR(enclosed_measure(mesh), exact, 1e-13 * exact);
    EXPECT_EQ(euler_characteristic(mesh), 1);
    EXPECT_EQ(boundary(mesh).non_manifold, 0);
  }
}

TEST_P(EveryKind, EveryElementIsTheRightWayOut) {
  const Mesh mesh = sample(GetParam(), 4, 3, 3);
  visit_mesh(mesh, [&]<class E, int D>(std::type_identity<E>, std::integral_constant<int, D>) {
    for (const auto& nodes : mesh.elements.colwise()) {
      const auto X_e = gather<E, D>(mesh.X, nodes.data());
      for (const auto& xi : E::corner_xi) EXPECT_GT(measure_ratio(jacobian<E>(X_e, xi)), 0);
    }
  });
}

TEST_P(EveryKind, BoundaryCountsAndMeasureAreExact) {
  const Mesh mesh = sample(GetParam(), 4, 3, 2);
  const Eigen::MatrixXi facets = boundary_facets(mesh);
  const ElementInfo& element = info(GetParam());
  const int split = element.corners == 4 && element.dimension == 3 ? 2 : 1;  // triangles on a cell's face
  EXPECT_EQ(facets.rows(), element.facet_nodes);
  EXPECT_EQ(facets.cols(), element.dimension == 2 ? 2 * (4 + 3) : split * 2 * (4 * 3 + 3 * 2 + 4 * 2));
  const double exact = element.dimension == 2 ? 2 * (2 + 1.5) : 2 * (2 * 1.5 + 1.5 * 0.7 + 2 * 0.7);
  EXPECT_NEAR(facet_measure(mesh, facets), exact, 1e-13 * exact);
  EXPECT_EQ(surface_facets(mesh), element.dimension == 2 ? mesh.elements : facets);
}

TEST_P(EveryKind, GroupsNameTheSidesExactly) {
  const Mesh mesh = sample(GetParam(), 4, 3, 2);
  const bool plane = info(GetParam()).dimension == 2;
  const Vec3 L(2, 1.5, plane ? 1 : 0.7);
  const char* names[3][2] = {{"left", "right"}, {"bottom", "top"}, {"back", "front"}};
  EXPECT_EQ(mesh.groups.size(), plane ? 4u : 6u);
  for (int axis = 0; axis < mesh.dimension(); ++axis) {
    for (int side = 0; side < 2; ++side) {
      const Group g = group(mesh, names[axis][side]);
      const double exact = L.prod() / L[axis];
      EXPECT_NEAR(facet_measure(mesh, g.facets), exact, 1e-14) << g.name;
      std::vector<int> expected;
      for (int n = 0; n < mesh.node_count(); ++n) {
        if (mesh.X(axis, n) == (side == 0 ? 0 : L[axis])) expected.push_back(n);
      }
      EXPECT_EQ(g.nodes, expected) << g.name;
      const std::set<int> of_facets(g.facets.reshaped().begin(), g.facets.reshaped().end());
      EXPECT_EQ(std::vector<int>(of_facets.begin(), of_facets.end()), expected) << g.name;
    }
  }
}

TEST_P(EveryKind, MiddleNodesLieHalfWayOnGradedMeshes) {
  const Mesh mesh = sample(GetParam());
  for (const auto& e : mesh.elements.colwise()) {
    for (const auto& [a, b, middle] : info(mesh.kind).edges) {
      if (middle < 0) continue;
      EXPECT_LT((mesh.X.col(e[a]) + mesh.X.col(e[b]) - 2 * mesh.X.col(e[middle])).norm(), 1e-15);
    }
  }
}

TEST(Generate, CountsNodesAndElements) {
  const Mesh rectangle = generate_rectangle({1, 1}, {5, 4}, {1, 1}, ElementKind::tri3);
  EXPECT_EQ(rectangle.node_count(), 30);
  EXPECT_EQ(rectangle.element_count(), 40);
  const Mesh quadratic = generate_rectangle({1, 1}, {5, 4}, {1, 1}, ElementKind::tri6);
  EXPECT_EQ(quadratic.node_count(), 11 * 9);
  const Mesh box = generate_box({4, 1, 1}, {32, 8, 8}, {1, 1, 1}, ElementKind::tet4);
  EXPECT_EQ(box.node_count(), 33 * 9 * 9);
  EXPECT_EQ(box.element_count(), 12288);
  const Mesh box10 = generate_box({1, 1, 1}, {3, 2, 4}, {1, 1, 1}, ElementKind::tet10);
  EXPECT_EQ(box10.node_count(), 7 * 5 * 9);  // every half-way lattice point is the middle of an edge of Kuhn's split
  EXPECT_EQ(generate_box({1, 1, 1}, {3, 2, 4}, {1, 1, 1}, ElementKind::hex8).element_count(), 24);
}

TEST(Generate, NodesPerElementAreAboutWhatTheElementSays) {
  constexpr int n = 16;  // the boundary adds (1 + 1/n)^3 at most
  for (const ElementInfo& element : elements()) {
    const Mesh mesh = element.dimension == 2 ? generate_rectangle({1, 1}, {n, n}, {1, 1}, element.kind)
                                             : generate_box({1, 1, 1}, {n, n, n}, {1, 1, 1}, element.kind);
    const int cells = element.dimension == 2 ? n * n : n * n * n;
    EXPECT_EQ(mesh.element_count(), cells * elements_per_cell(element.kind)) << element.name;
    const double ratio = double(mesh.node_count()) / mesh.element_count() / element.nodes_per_element;
    EXPECT_GT(ratio, 1) << element.name;
    EXPECT_LT(ratio, 1.25) << element.name;
  }
}

TEST(Generate, GradingFollowsThePower) {
  const Mesh mesh = generate_rectangle({3, 2}, {4, 2}, {2, 0.5}, ElementKind::quad4);
  for (int i = 0; i <= 4; ++i) EXPECT_DOUBLE_EQ(mesh.X(0, i), 3 * std::pow(i / 4.0, 2));
  for (int j = 0; j <= 2; ++j) EXPECT_DOUBLE_EQ(mesh.X(1, 5 * j), 2 * std::sqrt(j / 2.0));
}

// With even cell counts the mesh is its own mirror image along each axis.
TEST(Generate, SimplexMeshesAreSymmetric) {
  for (const ElementKind kind : {ElementKind::tri3, ElementKind::tet4}) {
    const bool plane = kind == ElementKind::tri3;
    const Mesh mesh =
        plane ? generate_rectangle({2, 2}, {4, 2}, {1, 1}, kind) : generate_box({2, 2, 2}, {4, 2, 2}, {1, 1, 1}, kind);
    const auto signature = [&](int axis) {
      std::set<std::multiset<std::vector<double>>> elements;
      for (const auto& e : mesh.elements.colwise()) {
        std::multiset<std::vector<double>> corners;
        for (const int n : e) {
          Eigen::VectorXd X = mesh.X.col(n);
          if (axis >= 0) X[axis] = 2 - X[axis];
          corners.insert({X.begin(), X.end()});
        }
        elements.insert(corners);
      }
      return elements;
    };
    for (int axis = 0; axis < mesh.dimension(); ++axis) EXPECT_EQ(signature(axis), signature(-1));
  }
}

TEST(Generate, SheetIsARectangleInSpace) {
  for (const ElementKind kind : {ElementKind::tri3, ElementKind::tri6}) {
    const Mesh flat = generate_rectangle({2, 1.5}, {4, 3}, {1.3, 1}, kind);
    const Mesh sheet = generate_sheet({2, 1.5}, {4, 3}, {1.3, 1}, kind);
    ASSERT_EQ(sheet.dimension(), 3);
    EXPECT_EQ(sheet.X.topRows(2), flat.X);
    EXPECT_EQ(sheet.X.row(2).cwiseAbs().maxCoeff(), 0);
    EXPECT_EQ(sheet.elements, flat.elements);
    EXPECT_NEAR(total_measure(sheet), 3, 1e-13);
    EXPECT_NEAR(facet_measure(sheet, boundary_facets(sheet)), 7, 1e-13);
    EXPECT_EQ(surface_facets(sheet), sheet.elements);
    EXPECT_EQ(group(sheet, "right").nodes, group(flat, "right").nodes);
  }
}

TEST(Generate, RefusesWhatCannotBeBuilt) {
  const auto box = [](Vec3 size, std::array<int, 3> cells, Vec3 grading, ElementKind kind = ElementKind::tet4) {
    return [=] { generate_box(size, cells, grading, kind); };
  };
  const Vec3 one(1, 1, 1);
  EXPECT_CONTAINS(error_of("mesh.cells", box(one, {4, 0, 1}, one)), "along y is 0; at least 1");
  EXPECT_CONTAINS(error_of("mesh.cells", box(one, {4, 1, -7}, one)), "along z is -7");
  EXPECT_CONTAINS(error_of("mesh.size", box({0, 1, 1}, {1, 1, 1}, one)), "along x is 0");
  EXPECT_CONTAINS(error_of("mesh.size", box({1, -2, 1}, {1, 1, 1}, one)), "along y is -2");
  EXPECT_CONTAINS(error_of("mesh.size", box({1, 1, NAN}, {1, 1, 1}, one)), "along z is nan");
  EXPECT_CONTAINS(error_of("mesh.size", box({INFINITY, 1, 1}, {1, 1, 1}, one)), "inf");
  EXPECT_CONTAINS(error_of("mesh.grading", box(one, {1, 1, 1}, {1, 0, 1})), "along y is 0");
  EXPECT_CONTAINS(error_of("mesh.grading", box(one, {1, 1, 1}, {1, 1, NAN})), "nan");
  EXPECT_CONTAINS(error_of("mesh.grading", box(one, {100, 1, 1}, {200, 1, 1})), "vanish");
  const int huge = 2147483647;
  EXPECT_CONTAINS(error_of("mesh.cells", box(one, {huge, huge, huge}, one)), "elements; at most");
  EXPECT_CONTAINS(error_of("mesh.cells", box(one, {1000, 1000, 1000}, one)), "6e+09 elements");
  EXPECT_CONTAINS(error_of("mesh.element", box(one, {1, 1, 1}, one, ElementKind::tri3)), "tet4, tet10 or hex8");
  EXPECT_CONTAINS(error_of("mesh.element",
                           [] {
                             generate_rectangle({1, 1}, {1, 1}, {1, 1}, ElementKind::hex8);
                           }),
                  "rectangle");
  EXPECT_CONTAINS(error_of("mesh.element",
                           [] {
                             generate_sheet({1, 1}, {1, 1}, {1, 1}, ElementKind::quad4);
                           }),
                  "sheet");
}

TEST(Boundary, FacetsOfThreeElementsAreReported) {
  Mesh fan;  // three triangles in space around one edge
  fan.kind = ElementKind::tri3;
  fan.X.resize(3, 5);
  fan.X << 0, 0, 1, -1, 0, 0, 0, 0, 0, 1, 0, 1, 0.5, 0.5, 0.5;
  fan.elements.resize(3, 3);
  fan.elements << 0, 0, 0, 1, 1, 1, 2, 3, 4;
  const Boundary b = boundary(fan);
  EXPECT_EQ(b.non_manifold, 1);
  EXPECT_EQ(b.facets.cols(), 6);
  EXPECT_EQ(b.elements, (std::vector<int>{0, 0, 1, 1, 2, 2}));
}

TEST_P(EveryKind, BoundaryNamesTheElementOfEachFacet) {
  const Mesh mesh = sample(GetParam(), 3, 3, 3);
  const Boundary b = boundary(mesh);
  ASSERT_EQ(b.elements.size(), static_cast<std::size_t>(b.facets.cols()));
  for (int f = 0; f < b.facets.cols(); ++f) {
    for (const int n : b.facets.col(f)) EXPECT_TRUE((mesh.elements.col(b.elements[f]).array() == n).any());
  }
}

TEST_P(EveryKind, SpatialOrderIsAPermutation) {
  const Mesh mesh = sample(GetParam(), 5, 4, 3);
  std::vector<int> order = spatial_order(mesh);
  EXPECT_EQ(order, spatial_order(mesh));
  std::sort(order.begin(), order.end());
  ASSERT_EQ(order.size(), static_cast<std::size_t>(mesh.element_count()));
  for (int e = 0; e < mesh.element_count(); ++e) EXPECT_EQ(order[e], e);
}

// A chunk of 192 tets (32 cells) in Morton order is a block of 4 x 4 x 2 cells with 75 nodes; row by row it is 32 cells
// in line with 132.
TEST(SpatialOrder, ChunksShareMoreNodes) {
  const Mesh mesh = generate_box({4, 1, 1}, {32, 8, 8}, {1, 1, 1}, ElementKind::tet4);
  const auto nodes_per_chunk = [&](const std::vector<int>& order) {
    double total = 0;
    for (std::size_t first = 0; first < order.size(); first += 192) {
      std::set<int> nodes;
      for (std::size_t k = first; k < first + 192; ++k) {
        for (const int n : mesh.elements.col(order[k])) nodes.insert(n);
      }
      total += static_cast<double>(nodes.size());
    }
    return total / (static_cast<double>(order.size()) / 192);
  };
  std::vector<int> rows(mesh.element_count());
  for (int e = 0; e < mesh.element_count(); ++e) rows[e] = e;
  EXPECT_DOUBLE_EQ(nodes_per_chunk(rows), 132);
  EXPECT_LE(nodes_per_chunk(spatial_order(mesh)), 80);
}

}  // namespace
}  // namespace sim::test
