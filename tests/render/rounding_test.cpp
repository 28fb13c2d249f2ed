#include "render/rounding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/render/shapes.h"

namespace {

using render::Rounding;

struct Rounded {
  std::vector<Eigen::Vector3f> positions, normals;
  std::vector<float> values;
  std::vector<std::uint32_t> triangles, edges;
};

Rounded rounded(const render::Surface& surface) {
  Rounded result;
  const render::Smoothing smoothing = render::smooth_groups(surface.positions, surface.triangles, surface.crease);
  result.edges = surface.edges;
  const std::vector<Rounding> levels = render::rounding_of(smoothing, result.edges);
  render::vertex_normals(smoothing, surface.positions, result.normals);
  for (const std::uint32_t v : smoothing.source) {
    result.positions.emplace_back(surface.positions[3 * v], surface.positions[3 * v + 1], surface.positions[3 * v + 2]);
    result.values.push_back(static_cast<float>(v));
  }
  result.triangles = smoothing.triangles;
  for (const Rounding& level : levels) {
    render::add_middles(level, result.positions, result.normals, result.values);
    result.triangles = level.triangles;
  }
  return result;
}

// An octahedron's eight faces on the unit sphere, all one smooth group.
render::Surface octahedron() {
  render::Surface surface;
  surface.positions = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
  surface.triangles = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  surface.edges = {0, 2, 2, 4, 4, 0};
  surface.crease = 180;
  return surface;
}

TEST(Rounding, ASphereBecomesRounder) {
  const Rounded sphere = rounded(octahedron());
  EXPECT_EQ(sphere.triangles.size(), 3U * 8 * 16);
  float least = 1, most = 0;
  for (std::size_t k = 0; k < sphere.triangles.size(); k += 3) {
    const Eigen::Vector3f middle = (sphere.positions[sphere.triangles[k]] + sphere.positions[sphere.triangles[k + 1]] +
                                    sphere.positions[sphere.triangles[k + 2]]) /
                                   3;
    least = std::min(least, middle.norm());
    most = std::max(most, middle.norm());
  }
  EXPECT_GT(least, 0.8F);  // the flat face: 0.577
  EXPECT_LT(most, 1.05F);
}

TEST(Rounding, FlatFacesAndTheirCreasesStayAsTheyAre) {
  render::Surface cube;
  for (int i = 0; i < 8; ++i) {
    for (int c = 0; c < 3; ++c) cube.positions.push_back(static_cast<float>(i >> c & 1));
  }
  cube.triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  const Rounded result = rounded(cube);
  for (const Eigen::Vector3f& p : result.positions) {
    const Eigen::Vector3f reach = (p.array() - 0.5F).abs();
    EXPECT_NEAR(reach.maxCoeff(), 0.5F, 1e-6) << p.transpose();  // on the cube's surface
  }
}

TEST(Rounding, LeavesNoGapsAndKeepsTheSense) {
  // Two balls that cut into each other: a crease all around.
  const Rounded balls = rounded(shapes::level_set(
      [](const render::Point& p) {
        const auto ball = [&](float x) { return std::hypot(p[0] - x, p[1] - 0.03F, p[2]) - 0.42F; };
        return std::min(ball(-0.31F), ball(0.37F));
      },
      10));
  // Edges meet by position: along each, as many triangles pass one way as the other.
  std::map<std::pair<std::array<float, 3>, std::array<float, 3>>, int> balance;
  const auto place = [&](std::uint32_t v) {
    return std::array{balls.positions[v].x(), balls.positions[v].y(), balls.positions[v].z()};
  };
  for (std::size_t k = 0; k < balls.triangles.size(); ++k) {
    const auto a = place(balls.triangles[k]), b = place(balls.triangles[k % 3 == 2 ? k - 2 : k + 1]);
    balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
  }
  for (const auto& [edge, sum] : balance) ASSERT_EQ(sum, 0);
}

TEST(Rounding, EdgesOfElementsLieOnTheFinerSurface) {
  const Rounded sphere = rounded(octahedron());
  EXPECT_EQ(sphere.edges.size(), 2U * 3 * 4);  // each of three edges in four pieces
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (std::size_t k = 0; k < sphere.triangles.size(); ++k) {
    const std::uint32_t a = sphere.triangles[k], b = sphere.triangles[k % 3 == 2 ? k - 2 : k + 1];
    sides.insert(std::minmax(a, b));
  }
  for (std::size_t k = 0; k < sphere.edges.size(); k += 2) {
    EXPECT_TRUE(sides.contains(std::minmax(sphere.edges[k], sphere.edges[k + 1])));
  }
}

TEST(Rounding, FineSurfacesAreLeftAlone) {
  const render::Surface fine = shapes::sphere({0, 0, 0}, 1, 60);
  std::vector<std::uint32_t> edges = fine.edges;
  EXPECT_TRUE(render::rounding_of(render::smooth_groups(fine.positions, fine.triangles, 40), edges).empty());
  EXPECT_EQ(edges, fine.edges);
}

}  // namespace
