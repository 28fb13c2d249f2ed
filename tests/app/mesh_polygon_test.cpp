// Polygons of surface files, whatever corner comes first, and seams that writers leave.
#include <Eigen/Geometry>
#include <numeric>

#include "app/mesh/polygon.h"
#include "tests/app/mesh_data.h"

namespace app {
namespace {

using Corners = std::vector<Eigen::Vector3d>;

double area_of_cut(const Corners& X, std::size_t& triangles) {
  const auto cut = cut_polygon(X);
  if (!cut) return -1;
  triangles = cut->size();
  double area = 0;
  for (const auto& [a, b, c] : *cut) area += (X[b] - X[a]).cross(X[c] - X[a]).norm() / 2;
  return area;
}

TEST(Polygon, AnySimplePolygonIsCutWhateverCornerComesFirst) {
  const Corners comb = {{0, 0, 1}, {5, 0, 1}, {5, 3, 1}, {4, 3, 1}, {4, 1, 1}, {3, 1, 1},
                        {3, 3, 1}, {2, 3, 1}, {2, 1, 1}, {1, 1, 1}, {1, 3, 1}, {0, 3, 1}};  // 5 + 3 teeth of 2 m^2
  for (std::size_t first = 0; first < comb.size(); ++first) {
    Corners X = comb;
    std::rotate(X.begin(), X.begin() + static_cast<std::ptrdiff_t>(first), X.end());
    for (const bool reversed : {false, true}) {
      if (reversed) std::reverse(X.begin(), X.end());
      std::size_t triangles = 0;
      EXPECT_NEAR(area_of_cut(X, triangles), 11, 1e-12) << first << reversed;
      EXPECT_EQ(triangles, 10u);
    }
  }
}

TEST(Polygon, CrossingSidesAreRefusedAndNoAreaIsNone) {
  EXPECT_FALSE(cut_polygon({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}}).has_value());
  EXPECT_TRUE(cut_polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}})->empty());
}

TEST(Polygon, TheCaseOfTwoFacesHasItsArea) {
  const auto read = read_data("cases/polygons.obj");
  ASSERT_EQ(read.mesh.element_count(), 4);
  double area = 0;
  for (const auto& nodes : read.mesh.elements.colwise()) {
    const Eigen::Vector3d a = read.mesh.X.col(nodes[0]), b = read.mesh.X.col(nodes[1]), c = read.mesh.X.col(nodes[2]);
    area += (b - a).cross(c - a).norm() / 2;
  }
  EXPECT_NEAR(area, 1.118034 + 1.802247, 1e-6);
}

TEST(Polygon, AFlatFaceIsLeftOutWithItsOwnLineAndNumbers) {
  const auto read = read_data("cases/flat-triangle.obj");
  EXPECT_EQ(read.mesh.element_count(), 3);
  ASSERT_FALSE(read.remarks.empty());
  EXPECT_NE(read.remarks[0].find("flat-triangle.obj:11: faces without area, left out: 1 (this is the first, of "
                                 "vertices 2 5 6)"),
            std::string::npos)
      << read.remarks[0];
}

TEST(Polygon, ALineOfAnObjGoesOnBehindABackslash) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const sim::Mesh whole = read_text(vertices + "f 1 2 3 4\n", "a.obj").mesh;
  for (const char* face : {"f 1 2 \\\n3 4\n", "f 1 2\\\n3 4\n", "f 1 2 3 4 \\\n\n", "f \\\n1 2 3 4\n"})
    expect_equal(whole, read_text(vertices + face, "A.OBJ").mesh);
}

TEST(Seams, VerticesThatATextureSplitsAreJoinedThoseOfTouchingSolidsAreNot) {
  const auto split = read_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nv 0 0 0\nv 1 1 0\nf 1 2 3\nf 5 6 4\n", "a.obj");
  EXPECT_EQ(split.mesh.node_count(), 4);
  EXPECT_EQ(split.remarks[0], "a.obj: nodes of open edges that stand where others do, joined with them: 2");
  // Two closed tets that share the place of one corner.
  const std::string tet = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  const std::string other = "v 0 0 0\nv -1 0 0\nv 0 -1 0\nv 0 0 -1\nf 5 6 7\nf 5 8 6\nf 6 8 7\nf 7 8 5\n";
  EXPECT_EQ(read_text(tet + other, "a.obj").mesh.node_count(), 8);
}

}  // namespace
}  // namespace app
