// Gmsh files: what Gmsh wrote is read alike from every variant, and what a file says reaches the mesh.
#include <Eigen/LU>

#include "app/mesh/error.h"
#include "tests/app/mesh_data.h"

namespace app {
namespace {

double tet_volume(const sim::Mesh& mesh, int element) {
  Eigen::Matrix3d edges;
  for (int i = 0; i < 3; ++i) {
    edges.col(i) = mesh.X.col(mesh.elements(i + 1, element)) - mesh.X.col(mesh.elements(0, element));
  }
  return edges.determinant() / 6;
}

// A text file of version 2.2 with the given nodes ("1 0 0 0") and elements ("1 2 2 0 1 1 2 3").
std::string msh2(const std::vector<std::string>& nodes, const std::vector<std::string>& elements,
                 const std::string& names = "") {
  std::string text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + names + "$Nodes\n" + std::to_string(nodes.size()) + "\n";
  for (const auto& node : nodes) text += node + "\n";
  text += "$EndNodes\n$Elements\n" + std::to_string(elements.size()) + "\n";
  for (const auto& element : elements) text += element + "\n";
  return text + "$EndElements\n";
}

const std::vector<std::string> square = {"1 0 0 0", "2 1 0 0", "3 1 1 0", "4 0 1 0"};
const std::vector<std::string> two_triangles = {"1 2 2 0 1 1 2 3", "2 2 2 0 1 1 3 4"};

TEST(MeshMsh, AllFourVariantsOfAMeshAreEqual) {
  for (const auto& files : {box_files, second_order_files}) {
    const ReadMesh first = read_data(files[0]);
    for (const auto& file : files) {
      SCOPED_TRACE(file);
      const ReadMesh other = read_data(file);
      expect_equal(first.mesh, other.mesh);
      EXPECT_TRUE(other.remarks.empty());
    }
  }
}

TEST(MeshMsh, BoxHasItsVolumeAndGroups) {
  for (const auto& file : {box_files[0], second_order_files[0]}) {
    SCOPED_TRACE(file);
    const sim::Mesh mesh = read_data(file).mesh;
    ASSERT_EQ(mesh.element_count(), 48);
    double volume = 0;
    for (int e = 0; e < mesh.element_count(); ++e) volume += tet_volume(mesh, e);
    EXPECT_NEAR(volume, 2, 1e-12);
    ASSERT_EQ(mesh.groups.size(), 5u);
    EXPECT_EQ(group(mesh, "all").elements.size(), 48u);
    EXPECT_EQ(static_cast<int>(group(mesh, "all").nodes.size()), mesh.node_count());
    for (const int e : group(mesh, "stiff").elements) {
      for (const int node : mesh.elements.col(e)) EXPECT_GE(mesh.X(0, node), 1 - 1e-12);
    }
    EXPECT_EQ(group(mesh, "stiff").elements.size(), 24u);
    EXPECT_EQ(group(mesh, "clamp here").facets.cols(), 4);
    for (const int node : group(mesh, "clamp here").nodes) EXPECT_EQ(mesh.X(0, node), 0);
    EXPECT_EQ(group(mesh, "7").facets.cols(), 4);
    for (const int node : group(mesh, "7").facets.reshaped()) EXPECT_EQ(mesh.X(0, node), 2);
    EXPECT_EQ(group(mesh, "edge").facets.size(), 0);
    for (const int node : group(mesh, "edge").nodes) EXPECT_EQ(mesh.X.col(node).tail<1>()(0), 1);
  }
}

TEST(MeshMsh, MiddleNodesOfTet10LieOnTheirEdges) {
  constexpr std::array<std::array<int, 2>, 6> edges = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
  for (const auto& file : second_order_files) {
    const sim::Mesh mesh = read_data(file).mesh;
    ASSERT_EQ(mesh.kind, sim::ElementKind::tet10);
    EXPECT_EQ(group(mesh, "7").facets.rows(), 6);
    EXPECT_EQ(group(mesh, "edge").nodes.size(), 3u);
    for (int e = 0; e < mesh.element_count(); ++e) {
      const auto X = [&](int local) { return Eigen::Vector3d(mesh.X.col(mesh.elements(local, e))); };
      for (int i = 0; i < 6; ++i) {
        EXPECT_LT((X(4 + i) - (X(edges[i][0]) + X(edges[i][1])) / 2).norm(), 1e-12) << file << " " << e << " " << i;
      }
    }
  }
}

TEST(MeshMsh, TextWithWindowsLineEndsIsTheSame) {
  for (const auto& file : {"box-2-text.msh", "box-4-text.msh", "box-second-4-text.msh"}) {
    const std::string text = with_crlf(read_all(data_folder() / file));
    expect_equal(read_data(file).mesh, read_text(text, "crlf.msh").mesh);
  }
}

TEST(MeshMsh, TheOtherByteOrderIsRead) {
  const auto swapped = [](auto value) {
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof(value));
    return std::string(bytes.rbegin(), bytes.rend());
  };
  std::string file = "$MeshFormat\n2.2 1 8\n" + swapped(1) + "\n$EndMeshFormat\n$Nodes\n3\n";
  for (int i = 1; i <= 3; ++i)
    file += swapped(i) + swapped(i == 2 ? 1.5 : 0.0) + swapped(i == 3 ? 2.0 : 0.0) + swapped(0.0);
  file += "\n$EndNodes\n$Elements\n1\n";
  for (const int number : {2, 1, 2, 1, 7, 1, 1, 2, 3}) file += swapped(number);
  file += "\n$EndElements\n";
  const sim::Mesh mesh = read_text(file, "swapped.msh").mesh;
  EXPECT_EQ(mesh.X, (Eigen::MatrixXd(2, 3) << 0, 1.5, 0, 0, 0, 2).finished());
  EXPECT_EQ(mesh.elements, Eigen::Vector3i(0, 1, 2));
  EXPECT_EQ(group(mesh, "7").elements, std::vector<int>{0});
}

TEST(MeshMsh, TrianglesInAPlaneOfEqualZAreTwoDimensional) {
  EXPECT_EQ(read_text(msh2(square, two_triangles), "a.msh").mesh.dimension(), 2);
  EXPECT_EQ(read_text(msh2({"1 0 0 3", "2 1 0 3", "3 1 1 3", "4 0 1 3"}, two_triangles), "a.msh").mesh.dimension(), 2);
  const auto lifted = msh2({"1 0 0 0", "2 1 0 0", "3 1 1 0.1", "4 0 1 0"}, two_triangles);
  EXPECT_EQ(read_text(lifted, "a.msh").mesh.dimension(), 3);
}

TEST(MeshMsh, QuadsAndHexesAreRead) {
  const sim::Mesh quad = read_text(msh2(square, {"1 3 2 0 1 1 2 3 4", "2 1 2 5 1 1 2"}), "a.msh").mesh;
  EXPECT_EQ(quad.kind, sim::ElementKind::quad4);
  EXPECT_EQ(group(quad, "5").facets, Eigen::Vector2i(0, 1));
  std::vector<std::string> cube = square;
  for (const char* node : {"5 0 0 1", "6 1 0 1", "7 1 1 1", "8 0 1 1"}) cube.push_back(node);
  const sim::Mesh hex = read_text(msh2(cube, {"1 5 2 0 1 1 2 3 4 5 6 7 8", "2 3 2 9 1 1 2 3 4"}), "a.msh").mesh;
  EXPECT_EQ(hex.kind, sim::ElementKind::hex8);
  EXPECT_EQ(group(hex, "9").facets.rows(), 4);
  EXPECT_EQ(error_of([&] {
              read_text(msh2({"1 0 0 0", "2 1 0 0", "3 1 1 0.5", "4 0 1 0"}, {"1 3 2 0 1 1 2 3 4"}), "a.msh");
            }),
            "a.msh: the z of quad4 elements goes from 0 to 0.5; it should be the same for all (a membrane in space is "
            "made of triangles)");
}

TEST(MeshMsh, UnusedNodesAreLeftOutAndCounted) {
  const auto read = read_text(
      msh2({"9 5 5 5", "1 0 0 0", "2 1 0 0", "30000000 0 0 7", "3 1 1 0", "4 0 1 0"}, two_triangles), "a.msh");
  expect_equal(read.mesh, read_text(msh2(square, two_triangles), "a.msh").mesh);
  EXPECT_EQ(read.remarks, std::vector<std::string>{"a.msh: nodes of no element, left out: 2 of 6"});
}

TEST(MeshMsh, GroupsApartFromTheBodyAreLeftOutWithARemark) {
  auto nodes = square;
  nodes.push_back("5 7 7 0");
  const auto read = read_text(msh2(nodes, {"1 2 2 0 1 1 2 3", "2 2 2 4 1 1 3 4", "3 1 2 8 1 1 2", "4 1 2 8 1 2 5"},
                                   "$PhysicalNames\n2\n1 8 \"low\"\n1 9 \"none\"\n$EndPhysicalNames\n"),
                              "a.msh");
  ASSERT_EQ(read.mesh.groups.size(), 2u);
  EXPECT_EQ(group(read.mesh, "low").nodes, (std::vector<int>{0, 1}));
  EXPECT_EQ(group(read.mesh, "low").facets.cols(), 1);
  EXPECT_EQ(group(read.mesh, "4").elements, std::vector<int>{1});
  ASSERT_EQ(read.remarks.size(), 3u);
  EXPECT_EQ(read.remarks[1], "a.msh: elements of groups that do not lie on the body, left out: 1");
  EXPECT_EQ(read.remarks[2], "a.msh: the physical group \"none\" is empty");
}

TEST(MeshMsh, RepeatedElementsAreOne) {
  const auto groups = read_text(msh2(square, {"1 2 2 5 1 1 2 3", "1 2 2 6 1 1 2 3", "2 2 2 6 1 1 3 4"}), "a.msh");
  EXPECT_EQ(groups.mesh.element_count(), 2);
  EXPECT_EQ(group(groups.mesh, "6").elements, (std::vector<int>{0, 1}));
  EXPECT_TRUE(groups.remarks.empty());
  const auto twice = read_text(msh2(square, {"1 2 2 5 1 1 2 3", "1 2 2 5 1 2 3 1", "2 2 2 6 1 1 3 4"}), "a.msh");
  EXPECT_EQ(twice.mesh.element_count(), 2);
  EXPECT_EQ(twice.remarks, std::vector<std::string>{"a.msh: elements that repeat others, left out: 1"});
}

// An L of a square and a triangle, as recombining leaves them.
TEST(MeshMsh, SquaresBesideTrianglesAreCut) {
  std::vector<std::string> corners = square;
  corners.push_back("5 2 0 0");
  const auto read = read_text(msh2(corners, {"1 3 2 7 1 1 2 3 4", "2 2 2 8 1 2 5 3"}), "a.msh");
  EXPECT_EQ(read.mesh.kind, sim::ElementKind::tri3);
  ASSERT_EQ(read.mesh.element_count(), 3);
  double area = 0;
  for (int e = 0; e < 3; ++e) {
    const Eigen::MatrixXd X = read.mesh.X(Eigen::indexing::all, read.mesh.elements.col(e));
    const double twice = (X(0, 1) - X(0, 0)) * (X(1, 2) - X(1, 0)) - (X(1, 1) - X(1, 0)) * (X(0, 2) - X(0, 0));
    EXPECT_GT(twice, 0);
    area += twice / 2;
  }
  EXPECT_NEAR(area, 1.5, 1e-15);
  EXPECT_EQ(group(read.mesh, "7").elements.size(), 2u);
  EXPECT_EQ(group(read.mesh, "8").elements.size(), 1u);
  EXPECT_EQ(read.remarks, std::vector<std::string>{"a.msh: squares beside triangles, cut into two triangles each: 1"});
}

TEST(MeshMsh, GroupsOfOneNameAreOneInEachDimension) {
  const auto read = read_text(msh2(square, {"1 2 2 1 1 1 2 3", "2 2 2 0 1 1 3 4", "3 1 2 1 1 3 4"}), "a.msh");
  ASSERT_EQ(read.mesh.groups.size(), 2u);
  EXPECT_EQ(read.mesh.groups[0].dimension, 1);
  EXPECT_EQ(read.mesh.groups[0].nodes, (std::vector<int>{2, 3}));
  EXPECT_EQ(read.mesh.groups[1].dimension, 2);
  EXPECT_EQ(read.mesh.groups[1].nodes, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(read.mesh.groups[1].elements, std::vector<int>{0});
  EXPECT_TRUE(read.remarks.empty());
  const auto named = read_text(msh2(square, {"1 2 2 1 1 1 2 3", "2 2 2 2 1 1 3 4"},
                                    "$PhysicalNames\n2\n2 1 \"sheet\"\n2 2 \"sheet\"\n$EndPhysicalNames\n"),
                               "a.msh");
  ASSERT_EQ(named.mesh.groups.size(), 1u);
  EXPECT_EQ(named.mesh.groups[0].elements, (std::vector<int>{0, 1}));
  EXPECT_EQ(named.remarks, std::vector<std::string>{
                               "a.msh: several physical groups of dimension 2 are called \"sheet\": taken as one"});
}

TEST(MeshMsh, UnknownSectionsArePassedOver) {
  const std::string text = msh2(square, two_triangles);
  const std::string more =
      "$Comments\nby hand $EndNodes\n$EndComments\n" + std::string("$NodeData\n1\n\"u\"\n$EndNodeData\n");
  const std::size_t at = text.find("$Nodes");
  expect_equal(read_text(text, "a.msh").mesh,
               read_text(text.substr(0, at) + more + text.substr(at) + more, "a.msh").mesh);
}

TEST(MeshMsh, SectionsMayStandBeforeTheFormatAndEndWithoutALine) {
  EXPECT_EQ(read_data("cases/comments-first.msh").mesh.element_count(), 1);
  const sim::Mesh mesh = read_data("cases/binary-element-data.msh").mesh;
  ASSERT_EQ(mesh.element_count(), 1);
  EXPECT_EQ(mesh.node_count(), 4);
  EXPECT_NEAR(tet_volume(mesh, 0), 1.0 / 6, 1e-15);
}

// What is wrong, and the message that must say it.
struct Wrong {
  std::string content, message;
};

TEST(MeshMsh, ErrorsSayLineValueAndRemedy) {
  const std::vector<Wrong> cases = {
      {msh2({"1 0 0 0", "2 1 nan 0", "3 1 1 0"}, {}), "a.msh:7: y is \"nan\"; it should be a finite number"},
      {msh2({"1 0 0 0", "2 1e999 0 0", "3 1 1 0"}, {}), "a.msh:7: x is \"1e999\"; it should be a finite number"},
      {msh2({"1 0 0 0", "2 1 0 0", "1 1 1 0"}, {}),
       "a.msh:8: two nodes above have the number 1; each node needs its own"},
      {msh2(square, {"1 2 2 0 1 1 2 5"}), "a.msh:13: an element refers to node 5, which is not among the nodes"},
      {msh2(square, {"1 2 2 0 1 1 2 1"}), "a.msh:13: node 1 stands twice in one tri3 element"},
      {msh2(square, {"1 99 2 0 1 1 2 1"}),
       "a.msh:13: element type 99 is not known; bodies are made of tri3, tri6, quad4, tet4, tet10 or hex8 (types 2, 9, "
       "3, "
       "4, 11, 5)"},
      {msh2({"1 0 0 0", "2 1 0 0", "3 1 1 0", "4 0 1 0", "5 2 0 0", "6 2 2 0"},
            {"1 2 2 0 1 1 2 3", "1 9 2 0 1 1 2 3 4 5 6"}),
       "a.msh: the body is made of 1 tri3 and 1 tri6; it should be of one kind"},
      {msh2(square, {"1 1 2 0 1 1 2"}),
       "a.msh: there are no triangles, squares, tets or hexes in it; a body is made of these (gmsh -2 or gmsh -3 makes "
       "them)"},
      {"$MeshFormat\n3 0 8\n$EndMeshFormat\n",
       "a.msh:2: MSH version \"3\" is not read; 1, 2.0 to 2.2, 4.0 and 4.1 are: gmsh -0 FILE -format msh41 -o NEW.msh "
       "writes the latter"},
      {"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n-1\n",
       "a.msh:5: the number of nodes is -1, but the 1 bytes that are left in the file have room for 0 to 0"},
      {"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", "a.msh:3: the file ends without a section $Nodes"},
      {"$MeshFormat\n2.2 1 8\n\2\0\0\0", "a.msh: offset 20: the file ends within the byte order mark"},
      {"solid cube\n", "a.msh:1: \"solid\" stands where a section such as $Nodes should begin"},
      {" \r\n", "a.msh: the file is empty"}};
  for (const Wrong& wrong : cases) {
    EXPECT_EQ(error_of([&] { read_text(wrong.content, "a.msh"); }), wrong.message);
    EXPECT_THROW(read_text(wrong.content, "a.msh"), FileError);
  }
}

}  // namespace
}  // namespace app
