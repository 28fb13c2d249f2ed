// Material points, and nodes and facets in regions.
#include <gtest/gtest.h>

#include <random>

#include "sim/mesh/locate.h"
#include "sim/mesh/transform.h"
#include "tests/sim/mesh_support.h"

namespace sim::test {
namespace {

class LocateKind : public testing::TestWithParam<ElementKind> {};
INSTANTIATE_TEST_SUITE_P(Mesh, LocateKind, testing::ValuesIn(all_kinds), kind_name);

Vec3 in_space(const Eigen::VectorXd& X) {
  Vec3 v = Vec3::Zero();
  v.head(X.size()) = X;
  return v;
}

Vec3 rest_position(const Mesh& mesh, const MaterialPoint& point) {
  Eigen::VectorXd X = Eigen::VectorXd::Zero(mesh.dimension());
  for (std::size_t i = 0; i < point.weights.size(); ++i) {
    X += point.weights[i] * mesh.X.col(mesh.elements(static_cast<int>(i), point.element));
  }
  return in_space(X);
}

template <class E>
std::array<double, E::dimension> random_xi(std::mt19937& random) {
  std::array<double, E::dimension> xi;
  std::uniform_real_distribution<double> uniform(E::corners == E::dimension + 1 ? 0.0 : -1.0, 1.0);
  double sum = 0;
  do {
    sum = 0;
    for (double& x : xi) sum += x = uniform(random);
  } while (E::corners == E::dimension + 1 && sum > 1);
  return xi;
}

void expect_random_points_found(const Mesh& mesh) {
  std::mt19937 random(11);
  visit_mesh(mesh, [&]<class E, int D>(std::type_identity<E>, std::integral_constant<int, D>) {
    for (int trial = 0; trial < 300; ++trial) {
      const int e = static_cast<int>(random() % mesh.element_count());
      const auto xi = random_xi<E>(random);
      const auto X_e = gather<E, D>(mesh.X, mesh.elements.col(e).data());
      const Vec3 X = in_space(position<E>(X_e, xi));
      const auto found = locate(mesh, X);
      ASSERT_TRUE(found.has_value()) << "element " << e;
      EXPECT_LT((rest_position(mesh, *found) - X).norm(), 1e-12);
      EXPECT_EQ(found->element, e);
      const auto N = E::N(xi);
      for (int i = 0; i < E::nodes; ++i) EXPECT_NEAR(found->weights[i], N[i], 1e-10);
    }
  });
}

TEST_P(LocateKind, FindsRandomPointsOfRandomElements) {
  expect_random_points_found(sample(GetParam(), 4, 3, 2));
  expect_random_points_found(bent(sample(GetParam(), 4, 3, 2)));
}

TEST_P(LocateKind, FindsNodesAndPointsOnTheBoundary) {
  const Mesh mesh = bent(sample(GetParam()));
  for (const auto& X : mesh.X.colwise()) {
    const auto found = locate(mesh, in_space(X));
    ASSERT_TRUE(found.has_value());
    EXPECT_LT((rest_position(mesh, *found) - in_space(X)).norm(), 1e-14);
  }
  const Mesh straight = sample(GetParam());
  const Vec3 corner = in_space(straight.X.rowwise().maxCoeff());
  EXPECT_TRUE(locate(straight, corner).has_value());
  EXPECT_TRUE(locate(straight, corner + Vec3(1e-10, 0, 0)).has_value());  // within 1e-9 of the size, 2 m
  EXPECT_FALSE(locate(straight, corner + Vec3(1e-8, 0, 0)).has_value());
  EXPECT_FALSE(locate(straight, corner + Vec3(1, 0, 0)).has_value());
  EXPECT_FALSE(locate(straight, {-1e-3, 0.5, 0.2}).has_value());
}

// Weights of a point on the far side of the tolerance stay those of the nearest point in the element.
TEST_P(LocateKind, WeightsArePartsOfOne) {
  const Mesh mesh = sample(GetParam());
  const auto found = locate(mesh, in_space(mesh.X.rowwise().maxCoeff()) + Vec3(5e-10, 5e-10, 0));
  ASSERT_TRUE(found.has_value());
  double sum = 0;
  for (const double w : found->weights) sum += w;
  EXPECT_NEAR(sum, 1, 1e-15);
}

TEST(Locate, ThirdCoordinateMeansNothingInThePlane) {
  const Mesh mesh = sample(ElementKind::tri3);
  EXPECT_TRUE(locate(mesh, {1, 1, 77}).has_value());
  EXPECT_EQ(nodes_in(mesh, Box{{-1, -1, 5}, {0, 9, 6}}), group(mesh, "left").nodes);
}

TEST(Locate, MembranesTurnedInSpace) {
  for (const ElementKind kind : {ElementKind::tri3, ElementKind::tri6}) {
    Mesh sheet = generate_sheet({2, 1}, {4, 2}, {1, 1}, kind);
    rotate(sheet, {1, 2, 3}, 40);
    expect_random_points_found(sheet);
    const Vec3 middle = sheet.X.rowwise().mean();
    const Vec3 normal =
        (sheet.X.col(1) - sheet.X.col(0)).head<3>().cross(Vec3(sheet.X.col(6) - sheet.X.col(0))).normalized();
    EXPECT_FALSE(locate(sheet, middle + 1e-6 * normal).has_value());
    EXPECT_TRUE(locate(sheet, middle + 1e-10 * normal).has_value());
  }
}

// The inverse map must not care for where and how large the body is, nor for thin elements.
TEST_P(LocateKind, HoldsFarAwayAndOnThinElements) {
  Mesh thin = sample(GetParam());
  scale(thin, {1, 1e-4, 1});
  expect_random_points_found(thin);
  Mesh far = sample(GetParam());
  translate(far, {1e4, -1e4, 1e4});
  const Vec3 X = in_space(far.X.col(far.elements(0, 5)) * 0.4 + far.X.col(far.elements(1, 5)) * 0.6);
  const auto found = locate(far, X);
  ASSERT_TRUE(found.has_value());
  EXPECT_LT((rest_position(far, *found) - X).norm(), 1e-11);
}

TEST_P(LocateKind, RegionsSelectNodes) {
  const Mesh mesh = sample(GetParam(), 4, 3, 2);
  EXPECT_EQ(nodes_in(mesh, InGroup{"right"}), group(mesh, "right").nodes);
  EXPECT_EQ(nodes_in(mesh, Box{{2, -1, -1}, {3, 9, 9}}), group(mesh, "right").nodes);  // inclusive
  EXPECT_TRUE(nodes_in(mesh, Box{{2.1, -1, -1}, {3, 9, 9}}).empty());
  EXPECT_EQ(nodes_in(mesh, Sphere{{0, 0, 0}, 0}), std::vector<int>{0});
  const double r = mesh.X(0, 1);  // distance of the next node along x
  const auto near = nodes_in(mesh, Sphere{{0, 0, 0}, r});
  for (int n = 0; n < mesh.node_count(); ++n) {
    const bool inside = std::find(near.begin(), near.end(), n) != near.end();
    EXPECT_EQ(inside, mesh.X.col(n).norm() <= r + 1e-12);
  }
  EXPECT_EQ(nodes_in(mesh, Sphere{{1, 1, 0}, 10}).size(), static_cast<std::size_t>(mesh.node_count()));
}

TEST_P(LocateKind, RegionsSelectFacets) {
  const Mesh mesh = sample(GetParam(), 4, 3, 2);
  const bool plane = info(GetParam()).dimension == 2;
  const double right = plane ? 1.5 : 1.5 * 0.7;
  EXPECT_NEAR(facet_measure(mesh, facets_in(mesh, InGroup{"right"})), right, 1e-14);
  EXPECT_NEAR(facet_measure(mesh, facets_in(mesh, Box{{2, -1, -1}, {2, 9, 9}})), right, 1e-14);
  EXPECT_EQ(facets_in(mesh, Sphere{{1, 1, 0}, 10}), boundary_facets(mesh));
  EXPECT_EQ(facets_in(mesh, Sphere{{1, 1, 0}, 1e-9}).cols(), 0);
  Mesh nodes_only = mesh;
  for (Group& g : nodes_only.groups) g.facets.resize(0, 0);
  EXPECT_NEAR(facet_measure(mesh, facets_in(nodes_only, InGroup{"right"})), right, 1e-14);
}

TEST(Locate, UnknownGroupsListTheKnownOnes) {
  Mesh mesh = sample(ElementKind::tri3);
  const std::string text = error_of("group", [&] { nodes_in(mesh, InGroup{"rigth"}); });
  EXPECT_CONTAINS(text, "no group \"rigth\"");
  EXPECT_CONTAINS(text, "\"left\", \"right\", \"bottom\", \"top\"");
  mesh.groups.clear();
  EXPECT_CONTAINS(error_of("group", [&] { facets_in(mesh, InGroup{"left"}); }), "no groups at all");
}

// Gmsh numbers groups for each dimension by itself.
TEST(Locate, AGroupIsToldByItsDimensionWhereItsNameIsNotEnough) {
  Mesh mesh = sample(ElementKind::tet4, 2, 2, 2);
  const Group left = find_group(mesh, {"left"}, GroupPart::nodes);
  mesh.groups = {{"1", left.nodes, {}, left.facets, 2}, {"1", {0, 1, 2, 3}, {0}, {}, 3}};
  EXPECT_EQ(nodes_in(mesh, InGroup{"1", 2}), left.nodes);
  EXPECT_EQ(nodes_in(mesh, InGroup{"1", 3}).size(), 4u);
  EXPECT_EQ(facets_in(mesh, InGroup{"1"}), left.facets);
  EXPECT_EQ(find_group(mesh, {"1"}, GroupPart::elements).dimension, 3);
  const std::string text = error_of("group", [&] { nodes_in(mesh, InGroup{"1"}); });
  EXPECT_CONTAINS(text, "2 groups are called \"1\", of dimension 2 (");
  EXPECT_CONTAINS(text, "3 (4 nodes): say which with dimension = 2");
  EXPECT_CONTAINS(error_of("group", [&] { nodes_in(mesh, InGroup{"1", 1}); }), "no group \"1\" of dimension 1");
}

}  // namespace
}  // namespace sim::test
