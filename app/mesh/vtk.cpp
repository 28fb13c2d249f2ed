#include "app/mesh/vtk.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "app/mesh/face_set.h"
#include "app/mesh/vtk_grid.h"
#include "app/mesh/vtk_numbers.h"

namespace app {
namespace {

constexpr bool from_big_endian = std::endian::native != std::endian::big;  // legacy files are big-endian

class VtkReader {
 public:
  explicit VtkReader(Cursor& in) : in_(in) {}

  // What the data are: polygons, or cells of several types.
  bool polygons() const { return polygons_; }

  VtkGrid read() {
    read_head();
    while (!in_.finished()) read_part();
    if (grid_.points.empty() || (grid_.types.empty() && !polygons_)) {
      in_.fail(std::string("the file ends without ") + (grid_.points.empty() ? "POINTS" : "CELL_TYPES"));
    }
    return std::move(grid_);
  }

 private:
  // "# vtk DataFile Version 3.0", a title, ASCII or BINARY, DATASET and its kind.
  void read_head() {
    for (const char* word : {"#", "VTK", "DATAFILE", "VERSION"}) in_.expect_keyword(word);
    version_ = in_.real("the version");
    in_.rest_of_line();
    in_.rest_of_line();
    const std::string coding = in_.keyword("ASCII or BINARY");
    if (coding != "ASCII" && coding != "BINARY") in_.fail(quote(coding) + " stands where ASCII or BINARY should be");
    binary_ = coding == "BINARY";
    in_.expect_keyword("DATASET");
    const std::string dataset = in_.keyword("the kind of data");
    polygons_ = dataset == "POLYDATA";
    if (dataset != "UNSTRUCTURED_GRID" && !polygons_) {
      in_.fail("the data are " + quote(dataset) + "; they should be UNSTRUCTURED_GRID or POLYDATA");
    }
    if (binary_) in_.use_offsets();
  }

  void read_part() {
    const std::string word = in_.keyword("a keyword");
    if (word == "POINTS") {
      const std::int64_t count = in_.whole("the number of points");
      const VtkType& type = vtk_type(in_, in_.word("the type of coordinates"));
      grid_.points = numbers<double>(type, times(count, 3));
    } else if (word == (polygons_ ? "POLYGONS" : "CELLS")) {
      read_cells();
    } else if (polygons_ && (word == "VERTICES" || word == "LINES")) {
      VtkGrid rest = std::exchange(grid_, {});
      read_cells();
      grid_ = std::move(rest);
    } else if (word == "TRIANGLE_STRIPS") {
      in_.fail("strips of triangles are not read; vtkTriangleFilter makes triangles of them");
    } else if (word == "CELL_TYPES") {
      grid_.types = numbers<std::int64_t>(vtk_type(in_, "int"), in_.whole("the number of cell types"));
    } else if (word == "CELL_DATA" || word == "POINT_DATA") {
      of_cells_ = word == "CELL_DATA";
      tuples_ = in_.whole("the number of values");
    } else if (word == "METADATA") {
      pass_over_metadata();
    } else {
      read_attribute(word);
    }
  }

  std::int64_t times(std::int64_t count, std::int64_t components) {
    constexpr std::int64_t most = std::int64_t{1} << 40;
    if (count < 0 || components < 0 || count > most || components > most / std::max<std::int64_t>(count, 1)) {
      in_.fail("the number of values, " + std::to_string(count) + " times " + std::to_string(components) +
               ", is more than any file can hold");
    }
    return count * components;
  }

  template <class T>
  std::vector<T> numbers(const VtkType& type, std::int64_t count) {
    if (binary_) in_.rest_of_line();
    return read_vtk_numbers<T>(in_, type, binary_, from_big_endian, count);
  }

  // Up to version 4: count and numbers in all; then number of nodes and nodes of each cell. From 5 on: count + 1 starts
  // and the nodes in a row.
  void read_cells() {
    const std::int64_t count = in_.whole("the number of cells"), total = in_.whole("the number of numbers");
    if (version_ < 5) return split(numbers<std::int64_t>(vtk_type(in_, "int"), total), count);
    in_.expect_keyword("OFFSETS");
    const std::vector<std::int64_t> starts =
        numbers<std::int64_t>(vtk_type(in_, in_.word("the type of offsets")), count);
    in_.expect_keyword("CONNECTIVITY");
    grid_.nodes = numbers<std::int64_t>(vtk_type(in_, in_.word("the type of the nodes")), total);
    if (starts.empty() || starts[0] != 0) in_.fail("the first offset should be 0");
    grid_.ends.assign(starts.begin() + 1, starts.end());
  }

  void split(const std::vector<std::int64_t>& list, std::int64_t count) {
    std::size_t at = 0;
    while (at < list.size()) {
      const std::int64_t nodes = list[at++];
      if (nodes < 0 || nodes > static_cast<std::int64_t>(list.size() - at)) {
        in_.fail("a cell has " + std::to_string(nodes) + " nodes, but " + std::to_string(list.size() - at) +
                 " numbers are left");
      }
      grid_.nodes.insert(grid_.nodes.end(), list.begin() + static_cast<std::ptrdiff_t>(at),
                         list.begin() + static_cast<std::ptrdiff_t>(at + static_cast<std::size_t>(nodes)));
      at += static_cast<std::size_t>(nodes);
      grid_.ends.push_back(static_cast<std::int64_t>(grid_.nodes.size()));
    }
    if (static_cast<std::int64_t>(grid_.ends.size()) != count) {
      in_.fail("there are " + std::to_string(grid_.ends.size()) + " cells, not " + std::to_string(count));
    }
  }

  // Values of cells or points: passed over, but for integers of the cells.
  void read_attribute(const std::string& word) {
    if (word == "FIELD") return read_field();
    const std::string name(in_.word("the name of the values"));
    if (word == "LOOKUP_TABLE") {
      return pass_over(vtk_type(in_, "unsigned_char"), times(in_.whole("the size of the table"), 4));
    }
    const bool scalars = word == "SCALARS";
    std::int64_t components = scalars ? 1 : word == "TENSORS" ? 9 : word == "VECTORS" || word == "NORMALS" ? 3 : 0;
    if (word == "TEXTURE_COORDINATES") components = in_.integer("the number of components", 1, 3);
    if (components == 0) in_.fail(quote(word) + " stands where a keyword such as CELLS should be");
    const VtkType& type = vtk_type(in_, in_.word("the type of values"));
    if (scalars) {
      if (!in_.line_finished()) components = in_.integer("the number of components", 1, 4);
      in_.expect_keyword("LOOKUP_TABLE");
      in_.word("the name of a table");
    }
    keep(name, type, components, tuples_);
  }

  // FIELD name n; then name, components, tuples, type and values of each.
  void read_field() {
    in_.word("the name of the field");
    const int arrays = in_.checked_count(in_.whole("the number of arrays"), 8, "the number of arrays");
    for (int i = 0; i < arrays; ++i) {
      const std::string name(in_.word("the name of an array"));
      if (name == "METADATA") {
        pass_over_metadata();
        --i;
        continue;
      }
      const std::int64_t components = in_.whole("the number of components"), tuples = in_.whole("the number of tuples");
      keep(name, vtk_type(in_, in_.word("the type of values")), components, tuples);
    }
  }

  void keep(const std::string& name, const VtkType& type, std::int64_t components, std::int64_t tuples) {
    const std::int64_t count = times(components, tuples);
    if (type.integer && components == 1 && of_cells_) {
      grid_.integers.emplace_back(name, numbers<std::int64_t>(type, count));
    } else {
      pass_over(type, count);
    }
  }

  void pass_over(const VtkType& type, std::int64_t count) {
    if (!binary_) {
      for (std::int64_t i = 0; i < count; ++i) in_.word("a value");
      return;
    }
    in_.rest_of_line();
    in_.bytes(type.size * static_cast<std::size_t>(in_.checked_count(count, type.size, "the number of values")),
              "values");
  }

  // Names of components and the like, up to an empty line.
  void pass_over_metadata() {
    in_.rest_of_line();
    while (!in_.rest_of_line().empty()) {
    }
  }

  Cursor& in_;
  double version_ = 0;
  bool binary_ = false, of_cells_ = false, polygons_ = false;
  std::int64_t tuples_ = 0;
  VtkGrid grid_;
};

sim::Mesh surface_of(Cursor& in, const VtkGrid& grid, std::vector<std::string>& remarks) {
  FaceSet faces(0);
  for (std::size_t i = 0; i + 2 < grid.points.size(); i += 3) {
    const Eigen::Vector3d& X = faces.vertices.emplace_back(Eigen::Map<const Eigen::Vector3d>(grid.points.data() + i));
    if (!X.allFinite()) in.fail("a coordinate is not a finite number");
  }
  std::size_t start = 0;
  for (const std::int64_t end : grid.ends) {
    if (end < static_cast<std::int64_t>(start) || end > static_cast<std::int64_t>(grid.nodes.size()))
      in.fail("the offsets of the polygons should rise, to the number of nodes");
    std::vector<int> corners;
    for (; start < static_cast<std::size_t>(end); ++start)
      corners.push_back(faces.checked_vertex(in, grid.nodes[start]));
    faces.add(in, corners);
  }
  return faces.mesh(in, remarks);
}

}  // namespace

sim::Mesh read_vtk(std::string_view content, std::string_view name, std::vector<std::string>& remarks) {
  Cursor in(content, name);
  VtkReader reader(in);
  const VtkGrid grid = reader.read();
  return reader.polygons() ? surface_of(in, grid, remarks) : make_mesh(in, grid, remarks);
}

}  // namespace app
