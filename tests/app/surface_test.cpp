#include "app/picture/surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "sim/mesh/boundary.h"
#include "sim/mesh/generate.h"

namespace app {
namespace {

using Eigen::Vector3f;

Vector3f vertex(const std::vector<float>& points, std::uint32_t v) {
  return {points[3 * v], points[3 * v + 1], points[3 * v + 2]};
}

double area(const std::vector<std::uint32_t>& triangles, const std::vector<float>& points) {
  double sum = 0;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const Vector3f a = vertex(points, triangles[t]);
    const Vector3f normal = (vertex(points, triangles[t + 1]) - a).cross(vertex(points, triangles[t + 2]) - a);
    sum += 0.5 * normal.norm();
  }
  return sum;
}

// Volume inside a closed surface (divergence theorem); positive when the triangles face outwards.
double volume(const std::vector<std::uint32_t>& triangles, const std::vector<float>& points) {
  double sum = 0;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const Vector3f a = vertex(points, triangles[t]), b = vertex(points, triangles[t + 1]);
    sum += a.dot(b.cross(vertex(points, triangles[t + 2]))) / 6;
  }
  return sum;
}

double length(const std::vector<std::uint32_t>& pairs, const std::vector<float>& points) {
  double sum = 0;
  for (std::size_t i = 0; i < pairs.size(); i += 2) {
    sum += (vertex(points, pairs[i]) - vertex(points, pairs[i + 1])).norm();
  }
  return sum;
}

// Every edge of a closed surface is passed once in each direction.
bool is_closed(const std::vector<std::uint32_t>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> passed;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    for (std::size_t i = 0; i < 3; ++i) ++passed[{triangles[t + i], triangles[t + (i + 1) % 3]}];
  }
  for (const auto& [edge, count] : passed) {
    const auto back = passed.find({edge.second, edge.first});
    if (count != 1 || back == passed.end() || back->second != 1) return false;
  }
  return true;
}

class SolidSurface : public testing::TestWithParam<sim::ElementKind> {};

TEST_P(SolidSurface, IsClosedAndFacesOutwards) {
  const sim::Mesh mesh = sim::generate_box({2, 1.5, 0.5}, {3, 2, 2}, {1, 1, 1}, GetParam());
  const Surface surface(mesh);
  const std::vector<float> points = surface.points(mesh.X);
  EXPECT_TRUE(is_closed(surface.triangles()));
  EXPECT_NEAR(volume(surface.triangles(), points), 1.5, 1e-5);
  EXPECT_NEAR(area(surface.triangles(), points), 2 * (3 + 1 + 0.75), 1e-5);
  EXPECT_TRUE(surface.outline().empty());
}

INSTANTIATE_TEST_SUITE_P(Elements, SolidSurface,
                         testing::Values(sim::ElementKind::tet4, sim::ElementKind::tet10, sim::ElementKind::hex8));

class PlaneSurface : public testing::TestWithParam<sim::ElementKind> {};

TEST_P(PlaneSurface, CoversTheMeshAndHasItsRim) {
  const sim::Mesh mesh = sim::generate_rectangle({2, 1.5}, {3, 2}, {1, 1}, GetParam());
  const Surface surface(mesh);
  const std::vector<float> points = surface.points(mesh.X);
  EXPECT_NEAR(area(surface.triangles(), points), 3, 1e-5);
  EXPECT_NEAR(length(surface.outline(), points), 7, 1e-5);
  for (std::size_t i = 2; i < points.size(); i += 3) EXPECT_EQ(points[i], 0);
}

INSTANTIATE_TEST_SUITE_P(Elements, PlaneSurface,
                         testing::Values(sim::ElementKind::tri3, sim::ElementKind::tri6, sim::ElementKind::quad4));

TEST(Surface, EdgesAreThoseOfTheElements) {
  const sim::Mesh quads = sim::generate_rectangle({2, 1}, {2, 1}, {1, 1}, sim::ElementKind::quad4);
  const Surface surface(quads);
  EXPECT_NEAR(length(surface.edges(), surface.points(quads.X)), 2 + 2 + 3, 1e-5);  // no diagonals of the drawing
  const sim::Mesh curved = sim::generate_rectangle({2, 1}, {2, 1}, {1, 1}, sim::ElementKind::tri6);
  const Surface subdivided(curved);
  EXPECT_NEAR(length(subdivided.edges(), subdivided.points(curved.X)), 7 + 2 * std::sqrt(2.0), 1e-5);
}

// One tri6 whose rim bulges: the quarter circle is followed to the sagitta of its pieces, not cut by a chord.
TEST(Surface, QuadraticEdgesAreDrawnCurved) {
  sim::Mesh mesh;
  mesh.kind = sim::ElementKind::tri6;
  const double diagonal = std::sqrt(0.5);
  mesh.X = Eigen::MatrixXd{{0, 1, 0, 0.5, diagonal, 0}, {0, 0, 1, 0, diagonal, 0.5}};
  mesh.elements = Eigen::VectorXi{{0, 1, 2, 3, 4, 5}};
  const Surface surface(mesh);
  const std::vector<float> points = surface.points(mesh.X);
  EXPECT_EQ(surface.triangles().size(), 3U * 16);
  EXPECT_EQ(surface.outline().size(), 2U * 12);
  // The parabola through three points of the circle has the area 1/2 + 2/3 (sqrt 2 - 1); four chords miss a sixteenth
  // of the last term. A single chord would give 1/2.
  const double bulge = 2.0 / 3 * (std::sqrt(2.0) - 1);
  EXPECT_NEAR(area(surface.triangles(), points), 0.5 + 15.0 / 16 * bulge, 1e-6);
}

// A pin shows under a skin at the vertex that its node moves most.
TEST(Surface, NodesAreFoundOnASkin) {
  const sim::Mesh box = sim::generate_box({1, 1, 1}, {2, 2, 2}, {1, 1, 1}, sim::ElementKind::tet4);
  sim::Mesh hull;
  hull.kind = sim::ElementKind::tri3;
  hull.elements = sim::surface_facets(box);
  hull.X = box.X;
  const Surface surface(box, make_skin(hull, box));
  const std::vector<float> points = surface.points(box.X);
  for (int node = 0; node < box.node_count(); ++node) {
    const int vertex = surface.vertex_of(node);
    ASSERT_GE(vertex, 0);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(points[std::size_t(3 * vertex + i)], box.X(i, node), 1e-6);
  }
}

TEST(Surface, ValuesFollowTheShapeFunctions) {
  const sim::Mesh mesh = sim::generate_box({1, 1, 1}, {1, 1, 1}, {1, 1, 1}, sim::ElementKind::tet10);
  const Surface surface(mesh);
  const Eigen::VectorXd squares = mesh.X.row(0).array().square();  // x^2 is in the space of the element
  const std::vector<float> points = surface.points(mesh.X);
  const std::vector<float> values = surface.values(squares);
  ASSERT_EQ(values.size(), points.size() / 3);
  for (std::size_t v = 0; v < values.size(); ++v) EXPECT_NEAR(values[v], points[3 * v] * points[3 * v], 1e-6);
}

}  // namespace
}  // namespace app
