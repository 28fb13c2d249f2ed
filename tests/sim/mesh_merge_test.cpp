// Nodes that stand at one place: found, counted and joined, and only those.
#include "sim/mesh/components.h"
#include "sim/mesh/merge.h"
#include "tests/sim/mesh_support.h"

namespace sim::test {
namespace {

// Every element of the mesh with nodes of its own.
Mesh cut_apart(const Mesh& whole) {
  Mesh mesh = whole;
  const auto nodes = static_cast<int>(whole.elements.rows());
  mesh.X.resize(whole.dimension(), whole.elements.size());
  for (int e = 0; e < whole.element_count(); ++e) {
    for (int i = 0; i < nodes; ++i) {
      mesh.X.col(e * nodes + i) = whole.X.col(whole.elements(i, e));
      mesh.elements(i, e) = e * nodes + i;
    }
  }
  mesh.groups.clear();
  return mesh;
}

TEST(Merge, AMeshThatWasCutApartIsWholeAgain) {
  for (const ElementKind kind : {ElementKind::tri3, ElementKind::tet4, ElementKind::hex8}) {
    const Mesh whole = sample(kind, 3, 2, 2);
    Mesh mesh = cut_apart(whole);
    EXPECT_EQ(count_coincident(mesh, coincidence(mesh)), mesh.node_count() - whole.node_count());
    const Joined joined = join_coincident(mesh, coincidence(mesh));
    EXPECT_EQ(joined.nodes, static_cast<int>(whole.elements.size()) - whole.node_count());
    EXPECT_EQ(joined.elements, 0);
    EXPECT_EQ(mesh.node_count(), whole.node_count());
    EXPECT_EQ(components(mesh).size(), 1u);
    for (int e = 0; e < whole.element_count(); ++e)
      for (int i = 0; i < whole.elements.rows(); ++i)
        EXPECT_EQ(mesh.X.col(mesh.elements(i, e)), whole.X.col(whole.elements(i, e)));
  }
}

TEST(Merge, TheDistanceIsALimitAndGroupsFollow) {
  Mesh mesh;
  mesh.kind = ElementKind::tri3;
  mesh.X = (Eigen::MatrixXd(2, 6) << 0, 1, 0, 1.001, 0, 1, 0, 0, 1, 0, 1.002, 1).finished();
  mesh.elements = (Eigen::MatrixXi(3, 2) << 0, 3, 1, 5, 2, 4).finished();
  mesh.groups = {{"cut", {1, 3}, {1}, (Eigen::MatrixXi(2, 1) << 3, 4).finished(), 1}};
  Mesh near = mesh;
  EXPECT_EQ(join_coincident(near, 0.0015).nodes, 1);
  EXPECT_EQ(near.elements, (Eigen::MatrixXi(3, 2) << 0, 1, 1, 4, 2, 3).finished());
  EXPECT_EQ(near.groups[0].nodes, std::vector<int>{1});
  EXPECT_EQ(near.groups[0].facets, (Eigen::MatrixXi(2, 1) << 1, 3).finished());
  EXPECT_EQ(join_coincident(mesh, 0.0025).nodes, 2);
}

TEST(Merge, ElementsThatCollapseGo) {
  Mesh mesh;
  mesh.kind = ElementKind::tri3;
  mesh.X = (Eigen::MatrixXd(2, 4) << 0, 1, 0, 1, 0, 0, 1, 1e-6).finished();
  mesh.elements = (Eigen::MatrixXi(3, 2) << 1, 0, 3, 1, 2, 2).finished();
  mesh.groups = {{"both", {0, 1, 2, 3}, {0, 1}, {}, 2}};
  const Joined joined = join_coincident(mesh, 1e-5);
  EXPECT_EQ(joined.elements, 1);
  EXPECT_EQ(mesh.elements, Eigen::Vector3i(0, 1, 2));
  EXPECT_EQ(mesh.groups[0].elements, std::vector<int>{0});
}

}  // namespace
}  // namespace sim::test
