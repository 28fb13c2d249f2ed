// One body written as different programs and editors write it: line ends, blanks, capitals, orders, parts.
#include <functional>

#include "app/base/text.h"
#include "app/mesh/error.h"
#include "tests/app/mesh_data.h"

namespace app {
namespace {

struct TextFile {
  std::string name, text;
  int elements;
};

const std::string tet_corners = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", tet_faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

std::string stl_text(const std::string& name) {
  std::string text = "solid " + name + "\n";
  for (const char* vertices : {"0 0 0 0 1 0 1 0 0", "0 0 0 1 0 0 0 0 1", "1 0 0 0 1 0 0 0 1", "0 0 0 0 0 1 0 1 0"}) {
    text += "facet normal 0 0 0\nouter loop\n";
    std::string numbers = vertices;
    for (std::size_t at = 0; at < numbers.size(); at += 6) text += "vertex " + numbers.substr(at, 5) + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid " + name + "\n";
}

std::string vtk_text(const std::string& kind, const std::string& cells) {
  return "# vtk DataFile Version 3.0\na title\nASCII\nDATASET " + kind + "\nPOINTS 4 float\n" + tet_corners + cells;
}

// A tet, or its surface, in every format that is text.
std::vector<TextFile> text_files() {
  return {{"a.msh",
           "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
           "$Elements\n1\n1 4 2 2 1 1 2 3 4\n$EndElements\n",
           1},
          {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n", 4},
          {"a.stl", stl_text("a b"), 4},
          {"a.ply",
           "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 4\nproperty list uchar int vertex_indices\nend_header\n" +
               tet_corners + tet_faces,
           4},
          {"a.off", "OFF\n4 4 6\n" + tet_corners + tet_faces, 4},
          {"a.vtk", vtk_text("UNSTRUCTURED_GRID", "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"), 1},
          {"a.mesh",
           "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 2\n"
           "Tetrahedra 1\n1 2 3 4 7\nEnd\n",
           1},
          {"a.inp",
           "*NODE, NSET=all\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n"
           "*ELEMENT, TYPE=C3D4, ELSET=tets\n1, 1, 2, 3, 4\n",
           1},
          {"a.veg",
           "*VERTICES\n4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n*ELEMENTS\nTET\n1 4 0\n1 1 2 3 4\n"
           "*MATERIAL rubber\nENU, 1000, 1e6, 0.45\n",
           1}};
}

std::string replaced_all(std::string text, const std::string& part, const std::string& by) {
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + by.size()))
    text.replace(at, part.size(), by);
  return text;
}

TEST(MeshVariants, LineEndsBlanksAndMarksOfEditorsChangeNothing) {
  const std::vector<std::function<std::string(const std::string&)>> variants = {
      with_crlf, [](const std::string& text) { return "\xEF\xBB\xBF" + text; },
      [](const std::string& text) { return replaced_all(text, "\n", "  \t\n"); },
      [](const std::string& text) { return text.substr(0, text.size() - 1); },
      [](const std::string& text) { return text + "\n\n"; }};
  for (const TextFile& file : text_files()) {
    const auto plain = read_text(file.text, file.name);
    EXPECT_EQ(plain.mesh.element_count(), file.elements) << file.name;
    EXPECT_EQ(plain.mesh.node_count(), 4) << file.name;
    for (std::size_t i = 0; i < variants.size(); ++i) {
      SCOPED_TRACE(file.name + " " + std::to_string(i));
      expect_equal(read_text(variants[i](file.text), file.name).mesh, plain.mesh);
    }
  }
}

TEST(MeshVariants, FortransExponentsAreNumbers) {
  const auto read = read_text("v 0 0 0\nv 1.5D+00 0 0\nv 0 2.d-1 0\nf 1 2 3\n", "a.obj");
  EXPECT_EQ(read.mesh.X, (Eigen::Matrix<double, 2, 3>() << 0, 1.5, 0, 0, 0, 0.2).finished());
  for (const char* none : {"1D", "D1", "1D+0D", "1.0D1e"})
    EXPECT_NE(
        error_of([&] { read_text(std::string("v 0 0 ") + none + "\n", "a.obj"); }).find("it should be a finite number"),
        std::string::npos)
        << none;
}

TEST(MeshVariants, KeywordsOfStlAndVtkMayBeInCapitalsOrNot) {
  expect_equal(read_text(in_capitals(stl_text("A B")), "a.stl").mesh, read_text(stl_text("A B"), "a.stl").mesh);
  const std::string text = vtk_text("UNSTRUCTURED_GRID", "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n");
  std::string small = text;
  std::ranges::transform(small, small.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  expect_equal(read_text(small, "a.vtk").mesh, read_text(text, "a.vtk").mesh);
}

TEST(MeshVariants, NamedPartsOfSurfacesAreGroups) {
  const sim::Mesh mesh =
      read_text(
          "o table\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng base low\nf 1 3 2\ng\nf 1 2 4\ng side\nf 2 3 4 \nf 1 4 3\n",
          "a.obj")
          .mesh;
  EXPECT_EQ(group(mesh, "table").elements, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(group(mesh, "base").elements, std::vector<int>{0});
  EXPECT_EQ(group(mesh, "low").nodes, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(group(mesh, "side").elements, (std::vector<int>{2, 3}));
  EXPECT_EQ(group(mesh, "side").dimension, 2);
  EXPECT_EQ(mesh.groups.size(), 4u);
  EXPECT_EQ(group(read_text(stl_text(" lid "), "a.stl").mesh, "lid").elements.size(), 4u);
}

TEST(MeshVariants, SectionsOfMeditStandInAnyOrder) {
  const auto read = read_text(
      "MeshVersionFormatted 1\nDimension 3\nTetrahedra\n1\n1 2 3 4 7\nCorners 1\n1\nTriangles 1\n1 2 3 5\n"
      "Ridges\n1\n1\nRequiredVertices\n1\n2\nVertices\n4\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 2\nNormals\n1\n0 0 1\n"
      "NormalAtVertices\n1\n1 1\nEnd\n",
      "a.mesh");
  EXPECT_EQ(read.mesh.element_count(), 1);
  EXPECT_EQ(group(read.mesh, "7").elements, std::vector<int>{0});
  EXPECT_EQ(group(read.mesh, "5").facets.cols(), 1);
}

TEST(MeshVariants, PolygonsOfVtkAreASurface) {
  const auto read = read_text(vtk_text("POLYDATA", "LINES 1 3\n2 0 1\nPOLYGONS 4 16\n" + tet_faces +
                                                       "CELL_DATA 4\nSCALARS a int\nLOOKUP_TABLE default\n1 2 3 4\n"),
                              "a.vtk");
  EXPECT_EQ(read.mesh.kind, sim::ElementKind::tri3);
  EXPECT_EQ(read.mesh.element_count(), 4);
  EXPECT_NE(error_of([] {
              read_text(vtk_text("POLYDATA", "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\n"), "a.vtk");
            }).find("strips of triangles are not read"),
            std::string::npos);
}

TEST(MeshVariants, PiecesOfAVtuAreOneGrid) {
  const auto piece = [](const std::string& x) {
    return R"(<Piece NumberOfPoints="4" NumberOfCells="1"><CellData><DataArray type="Int32" Name="part" format="ascii">)" +
           x + R"(</DataArray></CellData><Points><DataArray type="Float32" format="ascii">)" + x + " 0 0 " + x +
           " 1 0 " + x + " 0 1 9 9 9" +
           R"(</DataArray></Points><Cells><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">4</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10</DataArray></Cells></Piece>)";
  };
  const std::string head = R"(<VTKFile type="UnstructuredGrid"><UnstructuredGrid>)",
                    tail = "</UnstructuredGrid></VTKFile>";
  const auto read = read_text(head + piece("1") + piece("2") + tail, "a.vtu");
  EXPECT_EQ(read.mesh.element_count(), 2);
  EXPECT_EQ(read.mesh.X.col(4), Eigen::Vector3d(2, 0, 0));
  EXPECT_EQ(group(read.mesh, "part=2").elements, std::vector<int>{1});
  EXPECT_NE(error_of([&] {
              read_text(head + piece("1") + replaced_all(piece("2"), "2 3<", "2 4<") + tail, "a.vtu");
            }).find("a cell refers to point 4, which its piece does not have"),
            std::string::npos);
}

TEST(MeshVariants, NamesOfGroupsMayHaveBlanksAndQuotes) {
  const auto read = read_text(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 2 \"the \"stiff\" part\"\n$EndPhysicalNames\n"
      "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n1\n1 4 2 2 1 1 2 3 4\n$EndElements\n",
      "a.msh");
  EXPECT_EQ(group(read.mesh, "the \"stiff\" part").elements, std::vector<int>{0});
}

// Gmsh cut the box in two (-part 2), and adds elements of another part's border (-part_ghosts).
TEST(MeshVariants, PartitionsOfGmshAreOneBodyWithItsGroups) {
  for (const char* file :
       {"box-parts-22.msh", "box-parts-40.msh", "box-parts-41.msh", "box-parts-41-binary.msh", "box-ghosts.msh"}) {
    SCOPED_TRACE(file);
    const sim::Mesh mesh = read_data(std::string("formats/") + file).mesh;
    EXPECT_EQ(mesh.element_count(), 48);
    EXPECT_EQ(group(mesh, "stiff").elements.size(), 24u);
    EXPECT_EQ(group(mesh, "clamp here").facets.cols(), 4);
  }
}

}  // namespace
}  // namespace app
