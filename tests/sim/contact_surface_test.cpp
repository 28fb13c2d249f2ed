// What touches what: surfaces, the search for pairs, and counts that make a flat surface flat.
#include <gtest/gtest.h>

#include <set>

#include "sim/contact/barrier.h"
#include "sim/contact/touch.h"
#include "tests/sim/contact_support.h"

namespace sim {
namespace {

Eigen::Matrix3Xd places(const Skin& skin, const Eigen::MatrixXd& X) {
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(skin.node.size()));
  for (std::size_t p = 0; p < skin.node.size(); ++p)
    x.col(static_cast<Eigen::Index>(p)).head(X.rows()) = X.col(skin.node[p]);
  return x;
}

// Every element: the surface is closed where it should be, its areas add up, and its corners are nodes.
TEST(Skin, OfEveryElementAddsUpToTheSurface) {
  for (const test::Kind& kind : test::kinds) {
    const Scene scene = test::free_body(kind, "linear");
    const Mesh& mesh = scene.bodies[0].mesh;
    Skin skin;
    skin.D = scene.dimension;
    add_part(skin, flat_faces(mesh, skin.D), mesh.X, 0, 0.5);
    const bool solid = info(mesh.kind).dimension == 3;
    const double surface = solid ? 2 * (1.2 * 1 + 1 * 0.9 + 0.9 * 1.2) : kind.membrane ? 1.2 : 2 * (1.2 + 1) * 0.5;
    double points = 0, edges = 0;
    for (const double area : skin.point_area) points += area;
    for (const double area : skin.edge_area) edges += area;
    EXPECT_NEAR(points, surface, 1e-12) << kind.element;
    if (skin.D == 3) {
      EXPECT_NEAR(edges, surface, 1e-12) << kind.element;
    }
    const auto rim = std::count(skin.faces_around.begin(), skin.faces_around.end(), 0);
    EXPECT_EQ(rim > 0, kind.membrane) << kind.element;
    // Euler's formula of a sphere, a disk, a circle.
    if (skin.D == 3)
      EXPECT_EQ(skin.node.size() + skin.faces.size() - skin.edges.size(), solid ? 2u : 1u) << kind.element;
    else
      EXPECT_EQ(skin.node.size(), skin.faces.size()) << kind.element;
  }
}

TEST(BroadPhase, FindsEveryPairWithinReach) {
  Skin skin;
  const Body low = test::box_body("low", {1, 1, 1}, 3, {0, 0, 0}),
             top = test::box_body("top", {1, 1, 1}, 4, {0.2, 1.02, 0.3});
  Eigen::MatrixXd X(3, low.mesh.node_count() + top.mesh.node_count());
  X << low.mesh.X, top.mesh.X;
  add_part(skin, flat_faces(low.mesh, 3), low.mesh.X, 0, 1);
  add_part(skin, flat_faces(top.mesh, 3), top.mesh.X, low.mesh.node_count(), 1);
  const Eigen::Matrix3Xd x = places(skin, X);
  const BroadPhase broad_phase(skin, x);
  const std::vector<Couple> couples = {{0, 1, 0.1, 1}, {1, 1, 0.05, 1}};
  Boxes boxes;
  for (Eigen::Index p = 0; p < x.cols(); ++p) boxes.points.emplace_back(x.col(p), x.col(p));
  std::vector<Candidate> found;
  ASSERT_TRUE(broad_phase.find(couples, 1000000, boxes, found));
  std::set<std::array<int, 4>> have;
  for (const Candidate& c : found)
    EXPECT_TRUE(have.insert({static_cast<int>(c.kind), c.first, c.second, c.couple}).second) << "twice";
  int near = 0;
  const auto look = [&](PairKind kind, int first, int second, int couple) {
    int points[4];
    Vec3 y[4];
    const int count = points_of(skin, {kind, first, second, couple}, points);
    if (std::set<int>(points, points + count).size() < static_cast<std::size_t>(count)) return;
    for (int i = 0; i < count; ++i) y[i] = x.col(points[i]);
    if (nearest(kind, y).d >= couples[couple].dh) return;
    ++near;
    EXPECT_TRUE(have.count({static_cast<int>(kind), first, second, couple}));
  };
  const auto &a = skin.parts[0], &b = skin.parts[1];
  for (int p = a.points.first; p < a.points.last; ++p)
    for (int f = b.faces.first; f < b.faces.last; ++f) look(PairKind::point_triangle, p, f, 0);
  for (int p = b.points.first; p < b.points.last; ++p) {
    for (int f = a.faces.first; f < a.faces.last; ++f) look(PairKind::point_triangle, p, f, 0);
    for (int f = b.faces.first; f < b.faces.last; ++f) look(PairKind::point_triangle, p, f, 1);
  }
  for (int e = a.edges.first; e < a.edges.last; ++e)
    for (int f = b.edges.first; f < b.edges.last; ++f) look(PairKind::edge_edge, e, f, 0);
  for (int e = b.edges.first; e < b.edges.last; ++e)
    for (int f = e + 1; f < b.edges.last; ++f) look(PairKind::edge_edge, e, f, 1);
  EXPECT_GT(near, 100);
  EXPECT_FALSE(broad_phase.find(couples, 10, boxes, found));
}

// A point over a flat surface counts once, wherever it is: over a face, an edge or a corner of its mesh.
TEST(Touch, PointOverAFlatSurfaceCountsOnce) {
  Body low = test::box_body("low", {1, 1, 1}, 4, {0, 0, 0});
  Body top = test::box_body("top", {0.02, 0.02, 0.02}, 1, {0, 0, 0});
  const std::vector<Couple> couples = {{0, 1, 0.01, 1}};
  const double gap = 0.004;
  for (const Vec3& over : {Vec3(0.5, 1, 0.5), Vec3(0.5, 1, 0.55), Vec3(0.55, 1, 0.6), Vec3(0.6252, 1, 0.6249)}) {
    Skin skin;
    Eigen::MatrixXd X(3, low.mesh.node_count() + 8);
    X << low.mesh.X, top.mesh.X;
    add_part(skin, flat_faces(low.mesh, 3), low.mesh.X, 0, 1);
    add_part(skin, flat_faces(top.mesh, 3), top.mesh.X, low.mesh.node_count(), 1);
    const Eigen::Matrix3Xd x = places(skin, X);
    // One point of the top alone is near.
    const int point = skin.parts[1].points.first;
    Eigen::Matrix3Xd moved = x;
    for (int p = point; p < skin.parts[1].points.last; ++p) moved.col(p) = over + Vec3(0, gap + (p > point), 0);
    double U = 0;
    Vec3 force = Vec3::Zero();
    std::vector<Touch> touches;
    for (int f = skin.parts[0].faces.first; f < skin.parts[0].faces.last; ++f)
      ASSERT_TRUE(add_touches(skin, couples, {PairKind::point_triangle, point, f, 0}, moved, touches));
    gather(touches);
    for (const Touch& touch : touches) {
      U += touch.weight * Barrier(touch.d, 0.01).b;
      Vec3 y[4];
      for (int i = 0; i < node_count(touch.feature); ++i) y[i] = moved.col(touch.point[i]);
      const Distance at(touch.feature, y);
      for (int i = 0; i < at.nodes; ++i)
        if (touch.point[i] == point) force -= touch.weight * Barrier(at.d, 0.01).first * at.c[i] * at.n;
    }
    EXPECT_NEAR(U / (skin.point_area[point] / 2 * Barrier(gap, 0.01).b), 1, 1e-12);
    EXPECT_LT(std::hypot(force.x(), force.z()), 1e-12 * force.norm());
  }
}

}  // namespace
}  // namespace sim
