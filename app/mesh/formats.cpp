#include "app/mesh/formats.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "app/mesh/abaqus.h"
#include "app/mesh/medit.h"
#include "app/mesh/msh.h"
#include "app/mesh/obj.h"
#include "app/mesh/off.h"
#include "app/mesh/ply.h"
#include "app/mesh/stl.h"
#include "app/mesh/tetgen.h"
#include "app/mesh/vega.h"
#include "app/mesh/vtk.h"
#include "app/mesh/vtu.h"

namespace app {
namespace {

constexpr std::array<MeshFormat, 11> format_table = {{{".msh ", "Gmsh", read_msh},
                                                      {".vtk ", "legacy VTK", read_vtk},
                                                      {".vtu ", "VTK XML, unstructured", read_vtu},
                                                      {".mesh ", "Medit", read_medit},
                                                      {".inp ", "Abaqus and CalculiX", read_abaqus},
                                                      {".veg ", "Vega", read_vega},
                                                      {".node .ele ", "TetGen", read_tetgen},
                                                      {".obj ", "Wavefront", read_obj},
                                                      {".stl ", "STL", read_stl},
                                                      {".ply ", "PLY", read_ply},
                                                      {".off ", "OFF", read_off}}};

// What is not read, and the command that makes a file of it that is. Gmsh meshes or converts what it opens.
struct Conversion {
  std::string_view endings, command;  // IN stands for the file, OUT for its name without the ending
};
constexpr std::array<Conversion, 4> conversions = {
    {{".geo .step .stp .iges .igs .brep ", "gmsh -3 IN -format msh41 -o OUT.msh"},
     {".med .unv .bdf .nas .cgns .p3d .celum .meshb .ir3 .mail ", "gmsh -0 IN -format msh41 -o OUT.msh"},
     {".xdmf .xmf .exo .e .ex2 .h5m .dat .post .su2 .avs .f3grid .dolfin .xml .hmf .tec .ugrid .wkt ",
      "meshio convert IN OUT.vtu"},
     {".gltf .glb .3mf .dae .fbx .3ds .x3d .wrl .blend ", "assimp export IN OUT.obj"}}};

std::string ending_of(std::string_view file_name) {
  std::string ending = std::filesystem::path(file_name).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

bool is_among(const std::string& ending, std::string_view endings) {
  return !ending.empty() && endings.find(ending + " ") != endings.npos;
}

std::string replaced(std::string text, std::string_view part, const std::string& by) {
  const std::size_t at = text.find(part);
  return at == text.npos ? text : text.replace(at, part.size(), by);
}

}  // namespace

std::span<const MeshFormat> mesh_formats() {
  return format_table;
}

const MeshFormat* find_mesh_format(std::string_view file_name) {
  const std::string ending = ending_of(file_name);
  const auto found =
      std::ranges::find_if(format_table, [&](const MeshFormat& format) { return is_among(ending, format.endings); });
  return found == format_table.end() ? nullptr : &*found;
}

std::string conversion_advice(std::string_view file_name) {
  const std::filesystem::path path(file_name);
  for (const Conversion& conversion : conversions) {
    if (!is_among(ending_of(file_name), conversion.endings)) continue;
    std::string command = replaced(std::string(conversion.command), "IN", path.filename().string());
    command = replaced(command, "OUT", path.stem().string());
    return "this format is not read; " + command + " makes a file of it that is";
  }
  std::string endings;
  for (const MeshFormat& format : format_table) {
    endings += (endings.empty() ? "" : ", ") + std::string(format.name) + " (" +
               std::string(format.endings.substr(0, format.endings.size() - 1)) + ")";
  }
  return "the format of a mesh file is told by the ending of its name; read are " + endings;
}

}  // namespace app
