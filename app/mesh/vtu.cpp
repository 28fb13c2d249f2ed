#include "app/mesh/vtu.h"

#include <algorithm>
#include <bit>

#include "app/mesh/vtk_grid.h"
#include "app/mesh/vtu_array.h"

namespace app {
namespace {

struct VtuArray {
  std::string around;  // name of the tag around it
  XmlTag tag;
};
struct VtuArrays {
  VtuCoding coding;
  std::vector<std::vector<VtuArray>> pieces;
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
  for (XmlTag tag = next_tag(in); !tag.name.empty(); tag = next_tag(in)) {
    if (tag.name == "VTKFile") {
      read_file_tag(in, tag, arrays.coding);
    } else if (tag.name == "Piece") {
      arrays.pieces.emplace_back();
    } else if (tag.name == "DataArray" && !arrays.pieces.empty()) {
      arrays.pieces.back().push_back({around, tag});
    } else if (tag.name == "AppendedData") {
      read_appended(in, tag, arrays.coding);
      break;
    } else if (!tag.name.starts_with('/')) {
      around = tag.name;
    }
  }
  if (arrays.pieces.empty()) in.fail("the file has no Piece of an UnstructuredGrid");
  return arrays;
}

VtkGrid read_piece(Cursor& in, const std::vector<VtuArray>& arrays, const VtuCoding& coding) {
  VtkGrid grid;
  for (const auto& [around, tag] : arrays) {
    const std::string array = tag.attribute("Name");
    const std::string components = tag.attribute("NumberOfComponents");
    if (around == "Points") grid.points = read_vtu_array<double>(in, tag, coding);
    if (around == "Cells" && array == "connectivity") grid.nodes = read_vtu_array<std::int64_t>(in, tag, coding);
    if (around == "Cells" && array == "offsets") grid.ends = read_vtu_array<std::int64_t>(in, tag, coding);
    if (around == "Cells" && array == "types") grid.types = read_vtu_array<std::int64_t>(in, tag, coding);
    if (around == "CellData" && (components.empty() || components == "1") &&
        vtk_type(in, tag.attribute("type")).integer)
      grid.integers.emplace_back(array, read_vtu_array<std::int64_t>(in, tag, coding));
  }
  return grid;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

// Each piece counts its points and nodes from 0. Arrays that not every piece has are no longer one number a cell.
void append(const Cursor& in, VtkGrid& grid, const VtkGrid& piece) {
  const auto points = static_cast<std::int64_t>(grid.points.size() / 3);
  const auto nodes = static_cast<std::int64_t>(grid.nodes.size());
  for (const std::int64_t node : piece.nodes) {
    if (node < 0 || node >= static_cast<std::int64_t>(piece.points.size() / 3))
      in.fail("a cell refers to point " + std::to_string(node) + ", which its piece does not have");
    grid.nodes.push_back(points + node);
  }
  for (const std::int64_t end : piece.ends) {
    if (end < 0 || end > static_cast<std::int64_t>(piece.nodes.size()))
      in.fail("an offset is " + std::to_string(end) + ", but the piece has " + std::to_string(piece.nodes.size()) +
              " nodes in its cells");
    grid.ends.push_back(nodes + end);
  }
  append(grid.points, piece.points);
  append(grid.types, piece.types);
  for (const auto& [name, numbers] : piece.integers) {
    const auto known = std::ranges::find(grid.integers, name, [](const auto& array) { return array.first; });
    if (known != grid.integers.end()) append(known->second, numbers);
  }
}

}  // namespace

std::vector<double> read_vtu_points(std::string_view content, std::string_view name) {
  Cursor in(content, name);
  const VtuArrays arrays = find_arrays(in);
  std::vector<double> points;
  for (const std::vector<VtuArray>& piece : arrays.pieces)
    for (const auto& [around, tag] : piece)
      if (around == "Points") append(points, read_vtu_array<double>(in, tag, arrays.coding));
  if (points.empty() || points.size() % 3 != 0) in.fail("the points are not three numbers each");
  return points;
}

sim::Mesh read_vtu(std::string_view content, std::string_view name, std::vector<std::string>& remarks) {
  Cursor in(content, name);
  const VtuArrays arrays = find_arrays(in);
  VtkGrid grid = read_piece(in, arrays.pieces[0], arrays.coding);
  for (std::size_t k = 1; k < arrays.pieces.size(); ++k)
    append(in, grid, read_piece(in, arrays.pieces[k], arrays.coding));
  if (grid.points.empty() || grid.types.empty()) in.fail("the grid has no points or no cells");
  return make_mesh(in, grid, remarks);
}

}  // namespace app
