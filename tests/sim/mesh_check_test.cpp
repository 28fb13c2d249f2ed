// What check_and_orient mends and what it refuses.
#include <gtest/gtest.h>

#include <limits>

#include "sim/mesh/check.h"
#include "sim/mesh/transform.h"
#include "tests/sim/mesh_support.h"

namespace sim::test {
namespace {

class CheckKind : public testing::TestWithParam<ElementKind> {};
INSTANTIATE_TEST_SUITE_P(Mesh, CheckKind, testing::ValuesIn(all_kinds), kind_name);

TEST_P(CheckKind, AGoodMeshIsLeftAlone) {
  const Mesh before = bent(sample(GetParam()));
  Mesh mesh = before;
  const MeshCheck report = check_and_orient(mesh);
  EXPECT_EQ(report.reoriented, 0);
  EXPECT_EQ(report.dropped_nodes, 0);
  EXPECT_EQ(report.dropped_facets, 0);
  EXPECT_EQ(mesh.X, before.X);
  EXPECT_EQ(mesh.elements, before.elements);
}

TEST_P(CheckKind, AMirroredMeshIsTurnedRightSideOut) {
  Mesh mesh = bent(sample(GetParam()));
  const double exact = total_measure(mesh);
  scale(mesh, {-1, 1, 1});
  EXPECT_NEAR(total_measure(mesh), -exact, 1e-14);
  EXPECT_EQ(check_and_orient(mesh).reoriented, mesh.element_count());
  EXPECT_NEAR(total_measure(mesh), exact, 1e-14);
  EXPECT_NEAR(enclosed_measure(mesh), exact, 1e-13);
  EXPECT_EQ(euler_characteristic(mesh), 1);
}

TEST_P(CheckKind, InvertedElementsAreFoundAndCounted) {
  Mesh mesh = bent(sample(GetParam()));
  const double exact = total_measure(mesh);
  int inverted = 0;
  visit_mesh(mesh, [&]<class E, int D>(std::type_identity<E>, std::integral_constant<int, D>) {
    for (int e = 0; e < mesh.element_count(); e += 3, ++inverted) {
      const Eigen::VectorXi nodes = mesh.elements.col(e);
      for (int i = 0; i < E::nodes; ++i) mesh.elements(i, e) = nodes[E::mirrored[i]];
    }
  });
  EXPECT_LT(total_measure(mesh), 0.7 * exact);
  EXPECT_EQ(check_and_orient(mesh).reoriented, inverted);
  EXPECT_NEAR(total_measure(mesh), exact, 1e-14);
  EXPECT_NEAR(enclosed_measure(mesh), exact, 1e-13);
}

TEST_P(CheckKind, FlatElementsAreRefusedByNumber) {
  const ElementInfo& element = info(GetParam());
  Mesh mesh = sample(GetParam());
  const int last = mesh.element_count() - 1;
  mesh.elements.col(last).setConstant(mesh.elements(0, last));  // all in one point
  const std::string text = error_of("mesh", [&] { check_and_orient(mesh); });
  EXPECT_CONTAINS(text, "element " + std::to_string(last) + " ");
  EXPECT_CONTAINS(text, element.dimension == 2 ? "no area: 0 m^2" : "no volume: 0 m^3");

  Mesh flat = sample(GetParam());
  flat.X.bottomRows(1).setZero();  // all in one plane or line
  EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(flat); }), "element 0 ");
}

// The limit is relative to the element: tiny bodies and thin slivers pass.
TEST_P(CheckKind, SmallAndThinElementsPass) {
  Mesh tiny = sample(GetParam());
  scale(tiny, {1e-9, 1e-9, 1e-9});
  EXPECT_EQ(check_and_orient(tiny).reoriented, 0);
  Mesh thin = sample(GetParam());
  scale(thin, {1, 1e-6, 1});
  EXPECT_EQ(check_and_orient(thin).reoriented, 0);
}

TEST_P(CheckKind, BadNumbersAreRefused) {
  const Mesh good = sample(GetParam());
  for (const int wrong : {-1, good.node_count(), std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    Mesh mesh = good;
    mesh.elements(1, 2) = wrong;
    EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(mesh); }), "element 2 names node " + std::to_string(wrong));
    mesh = good;
    mesh.groups[0].nodes.push_back(wrong);
    EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(mesh); }), "group \"left\" names node");
    mesh = good;
    mesh.groups[1].facets(0, 0) = wrong;
    EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(mesh); }), "group \"right\" names node");
  }
  Mesh mesh = good;
  mesh.groups[0].elements = {good.element_count()};
  EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(mesh); }), "names element");
  mesh = good;
  mesh.groups[0].facets.conservativeResize(1, Eigen::NoChange);
  EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(mesh); }), "facets of 1 nodes");
  for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    mesh = good;
    mesh.X(1, 4) = wrong;
    EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(mesh); }), "node 4 is at");
  }
}

TEST_P(CheckKind, WrongShapesAreRefused) {
  const Mesh good = sample(GetParam());
  Mesh mesh = good;
  mesh.elements.resize(mesh.elements.rows(), 0);
  EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(mesh); }), "empty");
  mesh = good;
  mesh.X.resize(mesh.X.rows(), 0);
  EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(mesh); }), "empty");
  mesh = good;
  mesh.elements = mesh.elements.topRows(2).eval();
  EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(mesh); }), "the elements list 2");
  mesh = good;
  mesh.X = mesh.X.topRows(1).eval();
  EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(mesh); }), "coordinates per node; there are 1");
}

TEST_P(CheckKind, UnusedNodesAreDroppedAndGroupsFollow) {
  const Mesh good = sample(GetParam());
  Mesh mesh = good;  // the same with a stray node in front and one at the end
  mesh.X.resize(good.X.rows(), good.node_count() + 2);
  mesh.X << Eigen::VectorXd::Constant(good.X.rows(), 9), good.X, Eigen::VectorXd::Constant(good.X.rows(), 8);
  mesh.elements.array() += 1;
  for (Group& g : mesh.groups) {
    for (int& n : g.nodes) ++n;
    g.facets.array() += 1;
  }
  Group& left = mesh.groups[0];
  left.nodes.insert(left.nodes.begin(), 0);
  left.facets.conservativeResize(Eigen::NoChange, left.facets.cols() + 1);
  left.facets.rightCols(1).setZero();
  const MeshCheck report = check_and_orient(mesh);
  EXPECT_EQ(report.dropped_nodes, 2);
  EXPECT_EQ(report.dropped_facets, 1);
  EXPECT_EQ(mesh.X, good.X);
  EXPECT_EQ(mesh.elements, good.elements);
  for (std::size_t g = 0; g < good.groups.size(); ++g) {
    EXPECT_EQ(mesh.groups[g].nodes, good.groups[g].nodes);
    EXPECT_EQ(mesh.groups[g].facets, good.groups[g].facets);
  }
}

TEST(Check, FoldedElementsAreRefused) {
  Mesh bow = generate_rectangle({1, 1}, {1, 1}, {1, 1}, ElementKind::quad4);
  std::swap(bow.elements(2, 0), bow.elements(3, 0));  // corners crossed: the two halves cancel
  EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(bow); }), "element 0 (quad4)");
  Mesh dart = generate_rectangle({1, 1}, {1, 1}, {1, 1}, ElementKind::quad4);
  dart.X.col(3) << 0.2, 0.2;  // not convex
  EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(dart); }), "is folded: det dX/dxi = -");
  Mesh hex = generate_box({1, 1, 1}, {1, 1, 1}, {1, 1, 1}, ElementKind::hex8);
  hex.X.col(7) << 0.2, 0.2, 0.2;
  EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(hex); }), "element 0 (hex8) is folded");
  for (const ElementKind kind : {ElementKind::tri6, ElementKind::tet10}) {
    Mesh mesh = sample(kind, 2, 2, 2);
    const auto e = mesh.elements.col(3);
    const int corners = info(kind).corners;  // the middle of edge 01 pulled beyond the quarter point
    mesh.X.col(e[corners]) = 0.2 * mesh.X.col(e[0]) + 0.8 * mesh.X.col(e[1]);
    EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(mesh); }), "is folded");
  }
}

// A flat membrane element in general position: rounding must not pass for area.
TEST(Check, FlatMembranesAreRefused) {
  for (const ElementKind kind : {ElementKind::tri3, ElementKind::tri6}) {
    Mesh sheet = generate_sheet({1, 1}, {2, 2}, {1, 1}, kind);
    sheet.X.row(1).setZero();
    rotate(sheet, {1, 2, 3}, 40);
    EXPECT_CONTAINS(error_of("mesh", [&] { check_and_orient(sheet); }), "no area");
  }
}

TEST(Check, MembranesHaveNoWrongSide) {
  Mesh sheet = generate_sheet({1, 1}, {2, 2}, {1, 1}, ElementKind::tri3);
  sheet.elements.row(0).swap(sheet.elements.row(1));
  EXPECT_EQ(check_and_orient(sheet).reoriented, 0);
  EXPECT_NEAR(total_measure(sheet), 1, 1e-15);
}

TEST(Transform, MovesTurnsAndScales) {
  Mesh mesh = generate_box({1, 2, 3}, {1, 1, 1}, {1, 1, 1}, ElementKind::tet4);
  const int corner = mesh.node_count() - 1;  // (1, 2, 3)
  rotate(mesh, {0, 0, 2}, 90);
  EXPECT_LT((mesh.X.col(corner) - Vec3(-2, 1, 3)).norm(), 1e-15);
  translate(mesh, {1, 1, -1});
  EXPECT_LT((mesh.X.col(corner) - Vec3(-1, 2, 2)).norm(), 1e-15);
  scale(mesh, {2, 3, -1});
  EXPECT_LT((mesh.X.col(corner) - Vec3(-2, 6, -2)).norm(), 1e-15);
  EXPECT_NEAR(total_measure(mesh), -36, 1e-13);

  Mesh plane = generate_rectangle({1, 2}, {1, 1}, {1, 1}, ElementKind::tri3);
  rotate(plane, {0, 0, -1}, 90);
  EXPECT_LT((plane.X.col(3) - Eigen::Vector2d(2, -1)).norm(), 1e-15);
  scale(plane, {2, 2, 0});
  EXPECT_NEAR(total_measure(plane), 8, 1e-14);
}

TEST(Transform, RefusesWhatCannotBe) {
  Mesh plane = generate_rectangle({1, 1}, {1, 1}, {1, 1}, ElementKind::tri3);
  EXPECT_CONTAINS(error_of("mesh.rotate", [&] { rotate(plane, {1, 0, 0}, 30); }), "not [1, 0, 0]");
  EXPECT_CONTAINS(error_of("mesh.rotate", [&] { rotate(plane, {0, 0, 0}, 30); }), "[0, 0, 0]");
  EXPECT_CONTAINS(error_of("mesh.rotate", [&] { rotate(plane, {0, 0, 1}, NAN); }), "nan");
  EXPECT_CONTAINS(error_of("mesh.scale", [&] { scale(plane, {1, 0, 1}); }), "[1, 0, 1]");
  EXPECT_CONTAINS(error_of("mesh.scale", [&] { scale(plane, {1, INFINITY, 1}); }), "inf");
}

}  // namespace
}  // namespace sim::test
