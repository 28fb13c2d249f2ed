#include "app/mesh/vtk_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>

#include "app/mesh/msh_contents.h"
#include "app/mesh/msh_mesh.h"

namespace app {
namespace {

// Where VTK's order of nodes is not Gmsh's: for each node of Gmsh's its place in VTK's. A pixel and a voxel count along
// x first, and Gmsh has the middles of the last two edges of a tet the other way round.
constexpr std::array<std::size_t, 4> pixel = {0, 1, 3, 2};
constexpr std::array<std::size_t, 8> voxel = {0, 1, 3, 2, 4, 5, 7, 6};
constexpr std::array<std::size_t, 10> vtk_tet10 = {0, 1, 2, 3, 4, 5, 6, 7, 9, 8};

// [VTK, vtkCellType.h and the figures of the VTK file formats]
struct VtkCell {
  int vtk, gmsh;
  std::span<const std::size_t> order;
};
constexpr std::array<VtkCell, 16> vtk_cells = {{{1, 15, {}},
                                                {3, 1, {}},
                                                {5, 2, {}},
                                                {8, 3, pixel},
                                                {9, 3, {}},
                                                {10, 4, {}},
                                                {11, 5, voxel},
                                                {12, 5, {}},
                                                {13, 6, {}},
                                                {14, 7, {}},
                                                {21, 8, {}},
                                                {22, 9, {}},
                                                {23, 16, {}},
                                                {24, 11, vtk_tet10},
                                                {25, 17, {}},
                                                {28, 10, {}}}};

const VtkCell* find_cell(std::int64_t type) {
  const auto found = std::ranges::find(vtk_cells, type, &VtkCell::vtk);
  return found == vtk_cells.end() ? nullptr : &*found;
}

// Arrays that programs write for what others call physical groups or references.
bool names_groups(const std::string& array) {
  constexpr std::array<std::string_view, 4> names = {"gmsh:physical", "medit:ref", "cell_tags", "CellEntityIds"};
  return std::ranges::find(names, array) != names.end();
}

bool makes_groups(const std::vector<std::int64_t>& numbers) {
  constexpr std::size_t most = 100;
  std::set<std::int64_t> different;
  for (const std::int64_t n : numbers) {
    different.insert(n);
    if (different.size() > most) return false;
  }
  return true;
}

class GridConversion {
 public:
  GridConversion(const Cursor& in, const VtkGrid& grid) : in_(in), grid_(grid) {
    for (const auto& array : grid.integers) {
      if (array.second.size() == grid.types.size() && makes_groups(array.second)) groups_.push_back(&array);
    }
  }

  MshContents contents() {
    if (grid_.points.size() % 3 != 0) in_.fail("the points have " + std::to_string(grid_.points.size()) + " numbers");
    for (const double x : grid_.points) {
      if (!std::isfinite(x)) in_.fail("a coordinate is not a finite number");
    }
    if (grid_.ends.size() != grid_.types.size()) {
      in_.fail("there are " + std::to_string(grid_.types.size()) + " types of cells, but " +
               std::to_string(grid_.ends.size()) + " cells");
    }
    contents_.coordinates = grid_.points;
    number_nodes_from(in_, 0, contents_);
    for (std::size_t c = 0; c < grid_.types.size(); ++c) add_cell(c);
    return std::move(contents_);
  }

 private:
  void add_cell(std::size_t c) {
    const VtkCell* cell = find_cell(grid_.types[c]);
    if (cell == nullptr) {
      in_.fail("cell " + std::to_string(c) + " (counted from 0) is of VTK's type " + std::to_string(grid_.types[c]) +
               ", which is not read");
    }
    const MshType& type = *find_msh_type(cell->gmsh);
    const std::int64_t start = c == 0 ? 0 : grid_.ends[c - 1];
    if (start < 0 || grid_.ends[c] - start != type.nodes ||
        grid_.ends[c] > static_cast<std::int64_t>(grid_.nodes.size())) {
      in_.fail("cell " + std::to_string(c) + " (counted from 0) should have " + std::to_string(type.nodes) +
               " nodes, as a " + std::string(type.name) + " has");
    }
    const auto* nodes = grid_.nodes.data() + start;
    std::vector<std::int64_t> ordered(nodes, nodes + type.nodes);
    for (std::size_t i = 0; i < cell->order.size(); ++i) ordered[i] = nodes[cell->order[i]];
    add_element(in_, type, groups_of(c, type.dimension), ordered, contents_);
  }

  std::vector<int> groups_of(std::size_t c, int dimension) {
    std::vector<int> tags;
    for (const auto* array : groups_) {
      const std::int64_t number = array->second[c];
      const bool plain = names_groups(array->first);
      if (plain && number == 0) continue;
      tags.push_back(
          contents_.tag_of(dimension, plain ? std::to_string(number) : array->first + "=" + std::to_string(number)));
    }
    return tags;
  }

  const Cursor& in_;
  const VtkGrid& grid_;
  std::vector<const std::pair<std::string, std::vector<std::int64_t>>*> groups_;
  MshContents contents_;
};

}  // namespace

sim::Mesh make_mesh(const Cursor& in, const VtkGrid& grid, std::vector<std::string>& remarks) {
  return make_mesh(GridConversion(in, grid).contents(), in.name(), remarks);
}

}  // namespace app
