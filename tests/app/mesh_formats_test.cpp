// Files that other programs wrote of one box, in every format: each is read to the same body, with its groups.
#include <Eigen/Geometry>

#include "app/mesh/error.h"
#include "app/mesh/formats.h"
#include "sim/element/element.h"
#include "tests/app/mesh_data.h"

namespace app {
namespace {

// Volume of tets, area of triangles, by their corners.
double measure_of_corners(const sim::Mesh& mesh) {
  double sum = 0;
  for (const auto& nodes : mesh.elements.colwise()) {
    const auto edge = [&](int i) { return Eigen::Vector3d(mesh.X.col(nodes[i]) - mesh.X.col(nodes[0])); };
    const Eigen::Vector3d area = edge(1).cross(edge(2));
    sum += sim::info(mesh.kind).dimension == 3 ? area.dot(edge(3)) / 6 : area.norm() / 2;
  }
  return sum;
}

std::vector<std::filesystem::path> format_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder() / "formats")) {
    if (entry.path().extension() != ".md") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

ReadMesh read_format_file(const std::string& name) {
  return read_data("formats/" + name);
}

// Nodes and the facets or elements of a group that some program called so.
void expect_group(const std::string& file, const std::string& name, std::size_t nodes, Eigen::Index facets,
                  std::size_t elements) {
  SCOPED_TRACE(file + " " + name);
  const sim::Mesh mesh = read_format_file(file).mesh;
  const auto is_it = [&](const sim::Group& g) {
    return g.name == name && g.facets.cols() == facets && g.elements.size() == elements;
  };
  const auto found = std::find_if(mesh.groups.begin(), mesh.groups.end(), is_it);
  ASSERT_NE(found, mesh.groups.end());
  EXPECT_EQ(found->nodes.size(), nodes);
}

TEST(MeshFormats, EveryProgramsFileOfTheBoxIsTheBox) {
  int solids = 0, surfaces = 0;
  for (const auto& file : format_files()) {
    SCOPED_TRACE(file.filename());
    std::vector<std::string> remarks;
    const sim::Mesh mesh = read_mesh(file, remarks);
    EXPECT_NEAR(measure_of_corners(mesh), 2, 1e-6);
    if (sim::info(mesh.kind).dimension == 2) {
      EXPECT_EQ(mesh.node_count(), 10);
      EXPECT_EQ(mesh.element_count(), 8);
      ++surfaces;
    } else {
      EXPECT_EQ(mesh.node_count(), file.string().find("second") == std::string::npos ? 23 : 113);
      EXPECT_EQ(mesh.element_count(), 48);
      ++solids;
    }
  }
  EXPECT_GE(solids, 25);
  EXPECT_GE(surfaces, 8);
}

TEST(MeshFormats, MiddleNodesOfTet10LieOnTheirEdgesInEveryFormat) {
  constexpr std::array<std::array<int, 2>, 6> edges = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
  int checked = 0;
  for (const auto& file : format_files()) {
    std::vector<std::string> remarks;
    const sim::Mesh mesh = read_mesh(file, remarks);
    if (mesh.kind != sim::ElementKind::tet10) continue;
    ++checked;
    for (const auto& nodes : mesh.elements.colwise()) {
      for (int i = 0; i < 6; ++i) {
        const auto [a, b] = edges[static_cast<std::size_t>(i)];
        const Eigen::Vector3d middle = (mesh.X.col(nodes[a]) + mesh.X.col(nodes[b])) / 2;
        ASSERT_LT((mesh.X.col(nodes[4 + i]) - middle).norm(), 1e-6) << file << " " << i;
      }
    }
  }
  EXPECT_GE(checked, 6);
}

TEST(MeshFormats, GroupsKeepTheNamesOfTheFile) {
  expect_group("box-1.msh", "3", 5, 4, 0);
  expect_group("box-40-text.msh", "clamp here", 5, 4, 0);
  expect_group("box-40-text.msh", "stiff", 14, 0, 24);
  expect_group("box-meshio.vtu", "7", 5, 4, 0);
  expect_group("box-meshio.vtu", "gmsh:geometrical=2", 14, 0, 24);
  expect_group("box-vtk-51-binary.vtk", "2", 14, 0, 24);
  expect_group("box-gmsh-text.vtk", "3", 5, 4, 0);
  expect_group("box-meshio.mesh", "2", 14, 0, 24);
  expect_group("box-gmsh.inp", "clamp_here", 5, 4, 0);
  expect_group("box-gmsh.inp", "stiff", 14, 0, 24);
  expect_group("box-gmsh.inp", "clamp_here", 5, 0, 0);  // the set of nodes
  expect_group("box-meshio.ele", "2", 14, 0, 24);
}

TEST(MeshFormats, AnAbaqusDeckHasSetsSurfacesAndThingsThatAreLeftOut) {
  const auto read = read_text(
      "*Heading\n two tets\n** a comment\n*Node, nset=ALL\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 0., 1., 0.\n4, 0., 0., 1.\n"
      "5, 1., 1., 1.\n*ELEMENT, TYPE=C3D4H,\n ELSET=Both\n10, 1, 2, 3,\n4\n20, 2, 3, 4, 5\n*Element, type=SPRINGA\n30, "
      "1, "
      "2\n"
      "*Elset, elset=first, generate\n10, 19, 1\n*Elset, elset=hidden, internal\n 20,\n*Elset, elset=again\nFIRST, 20\n"
      "*Nset, nset=\"two nodes\"\n1, 5\n*Surface, type=ELEMENT, name=front\nhidden, S4\n*Material, "
      "name=m\n*Elastic\n1e6, "
      "0.3\n",
      "a.inp");
  EXPECT_EQ(read.mesh.element_count(), 2);
  EXPECT_EQ(group(read.mesh, "first").elements, std::vector<int>{0});
  EXPECT_EQ(group(read.mesh, "again").elements, (std::vector<int>{0, 1}));
  EXPECT_EQ(group(read.mesh, "two nodes").nodes, (std::vector<int>{0, 4}));
  EXPECT_EQ(group(read.mesh, "front").facets, Eigen::Vector3i(3, 4, 1));
  EXPECT_EQ(read.mesh.groups.size(), 6u);  // ALL, Both, first, again, two nodes, front; not hidden
  ASSERT_EQ(read.remarks.size(), 1u);
  EXPECT_EQ(read.remarks[0], "a.inp: elements of type \"SPRINGA\", left out: 1");
}

TEST(MeshFormats, VegaHasSetsOfElements) {
  const auto read = read_text(
      "# made by hand\n*VERTICES\n5 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n*ELEMENTS\nTET\n2 4 0\n1 1 2 3 "
      "4\n2 2 3 4 5\n*MATERIAL soft\nENU, 1000, 1e6, 0.45\n*SET upper\n2\n*REGION\nupper, soft\n",
      "a.veg");
  EXPECT_EQ(read.mesh.kind, sim::ElementKind::tet4);
  EXPECT_EQ(group(read.mesh, "upper").elements, std::vector<int>{1});
  EXPECT_TRUE(read.remarks.empty());
}

TEST(MeshFormats, ErrorsSayPlaceValueAndRemedy) {
  const auto message = [](const std::string& text, const char* name) {
    return error_of([&] { read_text(text, name); });
  };
  EXPECT_EQ(message("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off"),
            "a.off:6: a face refers to vertex 3; the number of vertices is 3, the first is 0");
  EXPECT_EQ(message("*NODE\n1, 0, , 0\n", "a.inp"), "a.inp:2: a coordinate is \"\"; it should be a finite number");
  EXPECT_EQ(message("*ELEMENT, TYPE=C3D4\n1,1,2,3,4\n*ELSET,ELSET=a\nb\n*ELSET,ELSET=b\na\n", "a.inp"),
            "a.inp:4: the set \"b\" contains itself");
  EXPECT_EQ(message("# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_GRID\n", "a.vtk"),
            "a.vtk:4: the data are \"STRUCTURED_GRID\"; they should be UNSTRUCTURED_GRID or POLYDATA");
  EXPECT_EQ(message("MeshVersionFormatted 2\nDimension 3\nTetrahedra\n1\n1 2 3 4 0\n", "a.mesh"),
            "a.mesh:5: the file ends without Vertices");
  EXPECT_EQ(message("ply\nformat xml 1.0\n", "a.ply"),
            "a.ply:2: the format is \"xml\"; it should be ascii, binary_little_endian or binary_big_endian");
  EXPECT_EQ(message("<VTKFile type=\"PolyData\">\n", "a.vtu"),
            "a.vtu:1: the data are \"PolyData\"; they should be UnstructuredGrid");
}

TEST(MeshFormats, WhatIsNotReadIsToldWithTheCommandThatConvertsIt) {
  EXPECT_EQ(
      error_of([] { read_text("HDF", "parts/wing.MED"); }),
      "parts/wing.MED: this format is not read; gmsh -0 wing.MED -format msh41 -o wing.msh makes a file of it that "
      "is");
  const std::string unknown = error_of([] { read_text("x", "a.xyz"); });
  for (const MeshFormat& format : mesh_formats())
    EXPECT_NE(unknown.find(std::string(format.name)), unknown.npos) << format.name;
  EXPECT_NE(find_mesh_format("BEAR.MSH"), nullptr);
}

}  // namespace
}  // namespace app
