#include "app/mesh/mesh_file.h"

#include "app/mesh/contents.h"
#include "app/mesh/error.h"
#include "app/mesh/formats.h"

namespace app {
namespace {

// Editors put the mark of UTF-8 in front, which is no part of any format.
std::string_view without_mark(std::string_view content) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return content.starts_with(mark) ? content.substr(mark.size()) : content;
}

}  // namespace

sim::Mesh read_mesh(std::string_view content, std::string_view name, std::vector<std::string>& remarks) {
  const MeshFormat* format = find_mesh_format(name);
  if (format == nullptr) throw FileError(std::string(name) + ": " + conversion_advice(name));
  if (content.find_first_not_of(" \t\r\n") == content.npos) throw FileError(std::string(name) + ": the file is empty");
  return format->read(without_mark(content), name, remarks);
}

sim::Mesh read_mesh(const std::filesystem::path& path, std::vector<std::string>& remarks) {
  if (find_mesh_format(path.string()) == nullptr && std::filesystem::exists(path)) {
    throw FileError(path.string() + ": " + conversion_advice(path.string()));
  }
  return read_mesh(read_contents(path), path.string(), remarks);
}

}  // namespace app
