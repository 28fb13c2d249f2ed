#include "app/mesh/mesh_file.h"

#include "app/mesh/contents.h"
#include "app/mesh/error.h"
#include "app/mesh/msh.h"
#include "app/mesh/obj.h"
#include "app/mesh/tetgen.h"

namespace app {

sim::Mesh read_mesh(std::string_view content, std::string_view name, std::vector<std::string>& remarks) {
  const std::size_t start = content.find_first_not_of(" \t\r\n");
  if (start == content.npos) throw FileError(std::string(name) + ": the file is empty");
  if (content.substr(start).starts_with("$MeshFormat")) return read_msh(content, name, remarks);
  if (name.ends_with(".obj") || name.ends_with(".OBJ")) return read_obj(content, name, remarks);
  throw FileError(std::string(name) + ":1: not a mesh that is known here: a Gmsh file starts with $MeshFormat " +
                  "(MSH 2.2 or 4.1), TetGen's two end in .node and .ele, a Wavefront file ends in .obj");
}

sim::Mesh read_mesh(const std::filesystem::path& path, std::vector<std::string>& remarks) {
  const std::string content = read_contents(path);
  if (path.extension() != ".node" && path.extension() != ".ele") return read_mesh(content, path.string(), remarks);
  const bool is_node = path.extension() == ".node";
  std::filesystem::path sibling = path;
  sibling.replace_extension(is_node ? ".ele" : ".node");
  const std::string other = read_contents(sibling);
  return is_node ? read_tetgen(content, path.string(), other, sibling.string(), remarks)
                 : read_tetgen(other, sibling.string(), content, path.string(), remarks);
}

}  // namespace app
