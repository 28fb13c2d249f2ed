#include "render/normals.h"

#include <gtest/gtest.h>

#include "tests/render/shapes.h"

namespace {

using Eigen::Vector3f;

// A cube [-1, 1]^3 of eight vertices.
struct Cube {
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                          2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  Cube() {
    for (int k = 0; k < 8; ++k) {
      for (int bit = 0; bit < 3; ++bit) positions.push_back((k >> bit & 1) != 0 ? 1.0F : -1.0F);
    }
  }
};

TEST(Normals, CubeIsSharpBelowNinetyDegreesAndRoundAbove) {
  const Cube cube;
  std::vector<Vector3f> normals;

  const render::Smoothing sharp = render::smooth_groups(cube.positions, cube.triangles, 80);
  EXPECT_EQ(sharp.source.size(), 24U);
  render::vertex_normals(sharp, cube.positions, normals);
  for (std::size_t copy = 0; copy < normals.size(); ++copy) {
    EXPECT_NEAR(normals[copy].cwiseAbs().maxCoeff(), 1, 1e-6);  // along an axis,
    const Vector3f at = Eigen::Map<const Vector3f>(cube.positions.data() + 3 * sharp.source[copy]);
    EXPECT_NEAR(normals[copy].dot(at), 1, 1e-6);  // outwards
  }

  const render::Smoothing round = render::smooth_groups(cube.positions, cube.triangles, 100);
  EXPECT_EQ(round.source.size(), 8U);
  EXPECT_EQ(round.triangles, cube.triangles);
}

TEST(Normals, FirstCopiesAreTheGivenVertices) {
  const Cube cube;
  const render::Smoothing sharp = render::smooth_groups(cube.positions, cube.triangles, 30);
  for (std::uint32_t v = 0; v < 8; ++v) EXPECT_EQ(sharp.source[v], v);
  for (std::size_t corner = 0; corner < cube.triangles.size(); ++corner) {
    EXPECT_EQ(sharp.source[sharp.triangles[corner]], cube.triangles[corner]);
  }
}

TEST(Normals, SphereNormalsPointFromTheCentre) {
  const render::Surface sphere =
      shapes::level_set([](const render::Point& p) { return std::hypot(p[0], p[1], p[2]) - 0.8F; }, 40);
  const render::Smoothing smoothing = render::smooth_groups(sphere.positions, sphere.triangles, 40);
  EXPECT_EQ(smoothing.source.size(), sphere.positions.size() / 3);  // no crease
  std::vector<Vector3f> normals;
  render::vertex_normals(smoothing, sphere.positions, normals);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Vector3f outwards = Eigen::Map<const Vector3f>(sphere.positions.data() + 3 * v).normalized();
    EXPECT_GT(normals[v].dot(outwards), std::cos(4 * M_PI / 180));
    EXPECT_NEAR(normals[v].norm(), 1, 1e-5);
  }
}

TEST(Normals, DegenerateTrianglesGiveUnitNormals) {
  const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 2, 0, 0, 5, 5, 5};  // on a line; the last one alone
  const render::Smoothing smoothing = render::smooth_groups(positions, {0, 1, 2, 0, 0, 0}, 40);
  std::vector<Vector3f> normals;
  render::vertex_normals(smoothing, positions, normals);
  for (const Vector3f& normal : normals) EXPECT_EQ(normal, Vector3f::UnitZ());
}

TEST(Normals, FanOfManyTrianglesIsQuick) {
  // A cone with 100,000 triangles at its tip: quadratic work would take minutes.
  constexpr int around = 100000;
  std::vector<float> positions = {0, 0, 1};
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < around; ++i) {
    const double angle = 2 * M_PI * i / around;
    positions.insert(positions.end(), {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0});
    triangles.insert(triangles.end(), {0, 1 + i, 1 + (i + 1) % around});
  }
  EXPECT_EQ(render::smooth_groups(positions, triangles, 40).source.size(), positions.size() / 3);
}

TEST(Normals, ClosedSurfacesAreKnown) {
  Cube cube;
  EXPECT_TRUE(render::is_closed(cube.triangles));
  EXPECT_TRUE(render::is_closed(shapes::bear(40).triangles));
  EXPECT_FALSE(render::is_closed(shapes::sphere({0, 0, 0}, 1, 8).triangles));  // its seam is open
  std::swap(cube.triangles[0], cube.triangles[1]);                             // one triangle turned round
  EXPECT_FALSE(render::is_closed(cube.triangles));
  cube.triangles.resize(33);
  EXPECT_FALSE(render::is_closed(cube.triangles));
}

}  // namespace
