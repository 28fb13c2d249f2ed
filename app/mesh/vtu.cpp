#include "app/mesh/vtu.h"

#include <bit>

#include "app/mesh/vtk_grid.h"
#include "app/mesh/vtu_array.h"

namespace app {
namespace {

struct VtuArrays {
  VtuCoding coding;
  std::vector<std::pair<std::string, XmlTag>> tags;  // of the DataArrays, with the name of the tag around each
};

void read_file_tag(const Cursor& in, const XmlTag& tag, VtuCoding& coding) {
  if (tag.attribute("type") != "UnstructuredGrid") {
    in.fail("the data are " + quote(tag.attribute("type")) + "; they should be UnstructuredGrid");
  }
  const std::string compressor = tag.attribute("compressor"), order = tag.attribute("byte_order");
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor") {
    in.fail("the compressor is " + quote(compressor) + "; vtkZLibDataCompressor is read, and none");
  }
  const char* own = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  coding.swapped = !order.empty() && order != own;
  coding.wide = tag.attribute("header_type") == "UInt64";
  coding.compressed = !compressor.empty();
}

// The appended data begin behind an underscore, and are the last of the file.
void read_appended(Cursor& in, const XmlTag& tag, VtuCoding& coding) {
  coding.appended_raw = tag.attribute("encoding") == "raw";
  in.go_to(tag.text_at);
  in.take("_", "the appended data");
  coding.appended = in.position();
}

VtuArrays find_arrays(Cursor& in) {
  VtuArrays arrays;
  std::string around;
  int pieces = 0;
  for (XmlTag tag = next_tag(in); !tag.name.empty(); tag = next_tag(in)) {
    if (tag.name == "VTKFile") {
      read_file_tag(in, tag, arrays.coding);
    } else if (tag.name == "Piece" && ++pieces > 1) {
      in.fail("a second Piece; one is read: save the grid as one piece");
    } else if (tag.name == "DataArray") {
      arrays.tags.emplace_back(around, tag);
    } else if (tag.name == "AppendedData") {
      read_appended(in, tag, arrays.coding);
      break;
    } else if (!tag.name.starts_with('/')) {
      around = tag.name;
    }
  }
  if (pieces == 0) in.fail("the file has no Piece of an UnstructuredGrid");
  return arrays;
}

}  // namespace

sim::Mesh read_vtu(std::string_view content, std::string_view name, std::vector<std::string>& remarks) {
  Cursor in(content, name);
  const VtuArrays arrays = find_arrays(in);
  VtkGrid grid;
  for (const auto& [around, tag] : arrays.tags) {
    const std::string array = tag.attribute("Name");
    const std::string components = tag.attribute("NumberOfComponents");
    if (around == "Points") grid.points = read_vtu_array<double>(in, tag, arrays.coding);
    if (around == "Cells" && array == "connectivity") grid.nodes = read_vtu_array<std::int64_t>(in, tag, arrays.coding);
    if (around == "Cells" && array == "offsets") grid.ends = read_vtu_array<std::int64_t>(in, tag, arrays.coding);
    if (around == "Cells" && array == "types") grid.types = read_vtu_array<std::int64_t>(in, tag, arrays.coding);
    if (around == "CellData" && (components.empty() || components == "1") &&
        vtk_type(in, tag.attribute("type")).integer)
      grid.integers.emplace_back(array, read_vtu_array<std::int64_t>(in, tag, arrays.coding));
  }
  if (grid.points.empty() || grid.types.empty()) in.fail("the grid has no points or no cells");
  return make_mesh(in, grid, remarks);
}

}  // namespace app
