// Solids from surfaces: volume and quality of what clean ones become, and what becomes of dirty ones.
#include "sim/fill/fill.h"

#include <numbers>

#include "sim/fill/carry.h"
#include "sim/fill/winding.h"
#include "sim/mesh/components.h"
#include "sim/mesh/dihedral.h"
#include "sim/mesh/locate.h"
#include "tests/sim/mesh_support.h"
#include "tests/sim/surfaces.h"

namespace sim::test {
namespace {

constexpr double pi = std::numbers::pi;

std::string reason(const Mesh& surface, double size) {
  try {
    fill(surface, size);
  } catch (const InputError& error) {
    return error.key + ": " + error.what();
  }
  return "";
}

TEST(Winding, CountsHowOftenASurfaceGoesRound) {
  const Mesh mesh = joined(ball(1), ball(2));
  const Eigen::Matrix3Xd X = mesh.X;
  const Eigen::Matrix3Xi triangles = mesh.elements;
  const Winding winding(X, triangles);
  EXPECT_NEAR(winding.at({0.1, 0.2, -0.3}), 2, 0.02);
  EXPECT_NEAR(winding.at({0, 1.5, 0}), 1, 0.02);
  EXPECT_NEAR(winding.at({0, 2.2, 0}), 0, 0.02);
  EXPECT_NEAR(winding.at({40, 30, 20}), 0, 1e-3);
}

TEST(Fill, ABallHasItsVolumeAndNoFlatTets) {
  double error = 1;
  for (const double size : {0.4, 0.2, 0.1}) {
    const Filling filling = fill(ball(1), size);
    const double now = std::abs(total_measure(filling.mesh) / (4 * pi / 3) - 1);
    EXPECT_LT(now, 0.6 * error) << size;
    error = now;
    EXPECT_GT(filling.smallest_angle, 9.0) << size;
    EXPECT_EQ(filling.smallest_angle, smallest_dihedral(filling.mesh));
    for (const auto& t : filling.mesh.elements.colwise()) {
      const Vec3 o = filling.mesh.X.col(t[0]);
      const Vec3 a = filling.mesh.X.col(t[1]) - o, b = filling.mesh.X.col(t[2]) - o, c = filling.mesh.X.col(t[3]) - o;
      ASSERT_GT(a.cross(b).dot(c), 0);
    }
    EXPECT_EQ(boundary(filling.mesh).non_manifold, 0);
  }
  EXPECT_LT(error, 0.02);
}

TEST(Fill, TheLatticeFitsTogether) {
  const Filling filling = fill(ball(1), 0.2);
  // Divergence theorem: right only where no face inside is left open.
  EXPECT_NEAR(enclosed_measure(filling.mesh), total_measure(filling.mesh), 1e-12);
  const Eigen::MatrixXi facets = boundary_facets(filling.mesh);
  for (const auto& nodes : facets.colwise())
    for (const int node : nodes) EXPECT_NEAR(filling.mesh.X.col(node).norm(), 1, 0.02);
}

TEST(Fill, TheSameSurfaceGivesTheSameBits) {
  const Mesh a = fill(ball(1), 0.23).mesh, b = fill(ball(1), 0.23).mesh;
  EXPECT_EQ(a.X, b.X);
  EXPECT_EQ(a.elements, b.elements);
}

TEST(Fill, EdgesAreAboutAsLongAsAsked) {
  const Mesh mesh = fill(ball(1), 0.2).mesh;
  double sum = 0;
  for (const auto& t : mesh.elements.colwise()) sum += (mesh.X.col(t[0]) - mesh.X.col(t[1])).norm();
  EXPECT_NEAR(sum / mesh.element_count(), 0.17, 0.02);  // some are shortened where they are moved onto the surface
}

TEST(Fill, CornersAreCutByLessThanAnEdge) {
  const Filling filling = fill(block_surface({2, 1, 1}), 0.1);
  EXPECT_NEAR(total_measure(filling.mesh), 2, 0.04);
  EXPECT_GT(filling.smallest_angle, 5);
}

TEST(Fill, WhatEnclosesNothingIsRefused) {
  EXPECT_EQ(reason(without_triangles(ball(1), 0, 1200), 0.2).find("mesh.surface: encloses nothing: "), 0);
  EXPECT_EQ(reason(ball(0.01), 0.5), "mesh.surface: encloses nothing as large as mesh.size");
  EXPECT_EQ(reason(ball(1), 1e-3),
            "mesh.size: makes a lattice of more than 4e6 vertices: the surface is 2e+03 times as long, and may be 122 "
            "times; a file in millimetres takes mesh.scale = 0.001");
}

// A cube of which one side is a group, and another one as well.
TEST(Fill, GroupsOfTheSurfaceAreGroupsOfTheSolid) {
  Mesh surface = block_surface({1, 1, 1});
  Group top{"top", {}, {}, {}, 2};
  for (int t = 0; t < surface.element_count(); ++t) {
    const auto corners = surface.elements.col(t);
    if (surface.X(2, corners[0]) + surface.X(2, corners[1]) + surface.X(2, corners[2]) > 3 - 1e-9)
      top.elements.push_back(t);
  }
  surface.groups = {top};
  const Mesh solid = fill(surface, 0.15).mesh;
  ASSERT_EQ(solid.groups.size(), 1U);
  const Group& group = solid.groups[0];
  EXPECT_EQ(group.name, "top");
  double area = 0;
  for (const auto& f : group.facets.colwise())
    area += (solid.X.col(f[1]) - solid.X.col(f[0]))
                .head<3>()
                .cross((solid.X.col(f[2]) - solid.X.col(f[0])).head<3>())
                .norm() /
            2;
  EXPECT_NEAR(area, 1, 0.1);  // edges are cut
  for (const int node : group.nodes) EXPECT_GT(solid.X(2, node), 0.85);
}

// Of a hundred and fifty equal balls none is a crumb; beside a ball of eight times their radius all are.
TEST(Fill, CrumbsAreSmallBesideTheLargestPart) {
  const Mesh one = ball(0.5, {0, 0, 0}, 1);
  Mesh many = one;
  for (int k = 1; k < 150; ++k) {
    Mesh next = one;
    next.X.colwise() += 1.5 * Vec3(k % 5, k / 5 % 5, k / 25);
    many = joined(many, next);
  }
  const Filling all = fill(many, 0.4);
  EXPECT_EQ(all.crumbs, 0);
  EXPECT_EQ(components(all.mesh).size(), 150U);
  EXPECT_EQ(fill(joined(one, ball(4, {6, 0, 0})), 0.4).crumbs, 1);
}

// A leg of a twentieth of the edges fills nothing; a ball inside of the block is a part of it.
TEST(Fill, PartsThatAreThinnerThanTheTetsAreCounted) {
  const Mesh body = block_surface({2, 2, 2});
  const Mesh leg = block_surface({0.02, 0.02, 1.5}, {0.91, 0.93, -1.7}), inside = ball(0.3, {1, 1, 1});
  EXPECT_EQ(fill(joined(body, leg), 0.4).lost, 1);
  EXPECT_EQ(fill(joined(body, inside), 0.4).lost, 0);
}

// Sides lie where the surface has them, as near as a region's box reaches.
TEST(Fill, FlatSidesLieOnTheSurface) {
  const Mesh solid = fill(block_surface({1, 1, 1}), 0.17).mesh;
  EXPECT_GT(nodes_in(solid, Box{{-1, -1, -1}, {0, 2, 2}}).size(), 10U);
  EXPECT_GT(nodes_in(solid, Box{{1, -1, -1}, {2, 2, 2}}).size(), 10U);
}

TEST(Carry, AnAffineMotionTakesThePointsAlongExactly) {
  const Mesh surface = ball(1);
  const Mesh mesh = fill(surface, 0.3).mesh;
  const std::vector<MaterialPoint> points = carry(mesh, surface.X);
  EXPECT_LT(farthest_outside(points), 1);
  Eigen::Matrix3d A;
  A << 1.2, 0.3, 0, -0.1, 0.9, 0.2, 0.4, 0, 1.1;
  for (int i = 0; i < surface.node_count(); ++i) {
    Vec3 x = Vec3::Zero();
    for (int a = 0; a < 4; ++a) x += points[i].weights[a] * (A * mesh.X.col(mesh.elements(a, points[i].element)));
    ASSERT_LT((x - A * surface.X.col(i)).norm(), 1e-12);
  }
}

TEST(Dihedral, OfARegularTetAndOfACorner) {
  EXPECT_NEAR(smallest_dihedral({Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)}),
              std::acos(1.0 / 3) * 180 / pi, 1e-12);
  EXPECT_NEAR(smallest_dihedral({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}),
              std::acos(1 / std::sqrt(3.0)) * 180 / pi, 1e-12);
}

}  // namespace
}  // namespace sim::test
