#include "sim/mesh/generate.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

#include "sim/element/element.h"
#include "sim/math/vec3.h"
#include "sim/mesh/boundary.h"
#include "sim/mesh/input_error.h"
#include "sim/mesh/quadratic.h"

namespace sim {
namespace {

constexpr const char* axis_name[] = {"x", "y", "z"};

// A lattice of cells; in two dimensions the third axis has no cells and one plane of nodes.
struct Lattice {
  int dimension;
  Vec3 lengths;
  std::array<int, 3> cells;
  Vec3 grading;

  int node(int i, int j, int k) const { return i + (cells[0] + 1) * (j + (cells[1] + 1) * k); }
};

template <class Value>
void refuse_axis(const std::string& key, int axis, Value value, const std::string& right) {
  std::ostringstream message;
  message << key.substr(key.find('.') + 1) << " along " << axis_name[axis] << " is " << value << "; " << right;
  throw InputError(key, message.str());
}

// per_cell: elements per cell. Counted in floating point because the product may exceed any integer.
void check(const Lattice& lattice, int per_cell, int nodes_per_element) {
  double cells = 1;
  for (int a = 0; a < lattice.dimension; ++a) {
    if (lattice.cells[a] < 1) refuse_axis("mesh.cells", a, lattice.cells[a], "at least 1 is needed");
    if (!std::isfinite(lattice.lengths[a]) || lattice.lengths[a] <= 0) {
      refuse_axis("mesh.size", a, lattice.lengths[a], "a length > 0 m is needed");
    }
    if (!std::isfinite(lattice.grading[a]) || lattice.grading[a] <= 0) {
      refuse_axis("mesh.grading", a, lattice.grading[a], "a number > 0 is needed (1: equal cells)");
    }
    cells *= lattice.cells[a];
  }
  // The longest list is the element's node numbers.
  const double entries = cells * per_cell * nodes_per_element, limit = std::numeric_limits<int>::max();
  if (entries > limit) {
    std::ostringstream message;
    message << "cells make " << cells * per_cell << " elements; at most " << std::floor(limit / nodes_per_element)
            << " of this kind can be numbered";
    throw InputError("mesh.cells", message.str());
  }
}

// x_i = L (i/n)^g
Eigen::VectorXd planes(double length, int cells, double grading) {
  Eigen::VectorXd x(cells + 1);
  for (int i = 0; i <= cells; ++i) x[i] = length * std::pow(static_cast<double>(i) / cells, grading);
  return x;
}

Eigen::MatrixXd nodes(const Lattice& lattice) {
  const int d = lattice.dimension;
  std::array<Eigen::VectorXd, 3> x;
  for (int a = 0; a < 3; ++a) {
    x[a] = a < d ? planes(lattice.lengths[a], lattice.cells[a], lattice.grading[a]) : Eigen::VectorXd::Zero(1);
    if (a < d && (x[a].tail(lattice.cells[a]) - x[a].head(lattice.cells[a])).minCoeff() <= 0) {
      refuse_axis("mesh.grading", a, lattice.grading[a],
                  "so many cells vanish with it; take it nearer to 1 or fewer cells");
    }
  }
  Eigen::MatrixXd X(d, x[0].size() * x[1].size() * x[2].size());
  Eigen::Index n = 0;
  for (const double z : x[2]) {
    for (const double y : x[1]) {
      for (const double x0 : x[0]) {
        const std::array<double, 3> at = {x0, y, z};
        for (int a = 0; a < d; ++a) X(a, n) = at[a];
        ++n;
      }
    }
  }
  return X;
}

// Kuhn's split of a cube into d! simplices, one for every order of the axes: the path from corner 0 to the opposite
// corner along them [Freudenthal 1942; Kuhn 1960]. Corners are bit masks (bit a: the high side of axis a); the first
// two of the middle are swapped where the order is odd, so that all have positive measure.
std::vector<std::vector<int>> kuhn_simplices(int dimension) {
  std::vector<int> axes(dimension);
  std::iota(axes.begin(), axes.end(), 0);
  std::vector<std::vector<int>> simplices;
  do {
    std::vector<int> corners = {0};
    int inversions = 0;
    for (int i = 0; i < dimension; ++i) {
      corners.push_back(corners.back() | 1 << axes[i]);
      for (int j = 0; j < i; ++j) inversions += axes[j] > axes[i];
    }
    if (inversions % 2 == 1) std::swap(corners[1], corners[2]);
    simplices.push_back(corners);
  } while (std::next_permutation(axes.begin(), axes.end()));
  return simplices;
}

// The element order of a cell's corners: counter-clockwise, bottom before top.
std::vector<std::vector<int>> whole_cell(int dimension) {
  if (dimension == 2) return {{0, 1, 3, 2}};
  return {{0, 1, 3, 2, 4, 5, 7, 6}};
}

// `pieces`: the elements of a cell by corner masks. With `mirror`, cells at odd positions along an axis are reflected
// in it: neighbours then agree on the diagonals of the face between them.
Eigen::MatrixXi fill(const Lattice& lattice, const std::vector<std::vector<int>>& pieces, bool mirror) {
  const auto& n = lattice.cells;
  const int layers = std::max(1, n[2]);
  const Eigen::Index count = static_cast<Eigen::Index>(n[0]) * n[1] * layers * static_cast<Eigen::Index>(pieces.size());
  Eigen::MatrixXi elements(pieces[0].size(), count);
  Eigen::Index e = 0;
  for (int k = 0; k < layers; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        const int reflect = mirror ? (i & 1) | (j & 1) << 1 | (k & 1) << 2 : 0;
        for (const auto& piece : pieces) {
          for (std::size_t c = 0; c < piece.size(); ++c) {
            const int at = piece[c] ^ reflect;
            const int up = lattice.dimension == 3 ? at >> 2 & 1 : 0;
            elements(c, e) = lattice.node(i + (at & 1), j + (at >> 1 & 1), k + up);
          }
          if (std::popcount(static_cast<unsigned>(reflect)) % 2 == 1) std::swap(elements(1, e), elements(2, e));
          ++e;
        }
      }
    }
  }
  return elements;
}

// The two sides across an axis: nodes and boundary facets with that coordinate (it is exact: 0 or L).
void add_sides(Mesh& mesh, const Eigen::MatrixXi& facets, int axis, double length) {
  constexpr const char* names[3][2] = {{"left", "right"}, {"bottom", "top"}, {"back", "front"}};
  for (int side = 0; side < 2; ++side) {
    Group group;
    group.name = names[axis][side];
    const double coordinate = side == 0 ? 0 : length;
    for (int n = 0; n < mesh.node_count(); ++n) {
      if (mesh.X(axis, n) == coordinate) group.nodes.push_back(n);
    }
    std::vector<int> on_side;
    for (int f = 0; f < facets.cols(); ++f) {
      if ((mesh.X(axis, facets.col(f)).array() == coordinate).all()) on_side.push_back(f);
    }
    group.facets = facets(Eigen::indexing::all, on_side);
    mesh.groups.push_back(std::move(group));
  }
}

Mesh generate(const Lattice& lattice, ElementKind kind) {
  const ElementInfo& element = info(kind);
  const auto pieces = element.simplex() ? kuhn_simplices(lattice.dimension) : whole_cell(lattice.dimension);
  check(lattice, static_cast<int>(pieces.size()), element.nodes);
  Mesh mesh;
  mesh.kind = element.linear;
  mesh.X = nodes(lattice);
  mesh.elements = fill(lattice, pieces, element.simplex());
  const Eigen::MatrixXi facets = boundary_facets(mesh);
  for (int a = 0; a < lattice.dimension; ++a) add_sides(mesh, facets, a, lattice.lengths[a]);
  return mesh.kind == kind ? mesh : to_quadratic(mesh);
}

void require(const std::string& shape, ElementKind kind, bool (*right)(const ElementInfo&)) {
  if (right(info(kind))) return;
  throw InputError("mesh.element", "a " + shape + " cannot have elements " + std::string(info(kind).name) + "; take " +
                                       element_list(right));
}

Lattice flat(const Eigen::Vector2d& lengths, std::array<int, 2> cells, const Eigen::Vector2d& grading) {
  return {2, {lengths[0], lengths[1], 0}, {cells[0], cells[1], 0}, {grading[0], grading[1], 1}};
}

}  // namespace

int elements_per_cell(ElementKind kind) {
  const ElementInfo& element = info(kind);
  return element.simplex() ? static_cast<int>(kuhn_simplices(element.dimension).size()) : 1;
}

Mesh generate_rectangle(const Eigen::Vector2d& lengths, std::array<int, 2> cells, const Eigen::Vector2d& grading,
                        ElementKind kind) {
  require("rectangle", kind, [](const ElementInfo& element) { return element.dimension == 2; });
  return generate(flat(lengths, cells, grading), kind);
}

Mesh generate_box(const Eigen::Vector3d& lengths, std::array<int, 3> cells, const Eigen::Vector3d& grading,
                  ElementKind kind) {
  require("box", kind, [](const ElementInfo& element) { return element.dimension == 3; });
  return generate({3, lengths, cells, grading}, kind);
}

Mesh generate_sheet(const Eigen::Vector2d& lengths, std::array<int, 2> cells, const Eigen::Vector2d& grading,
                    ElementKind kind) {
  require("sheet", kind, [](const ElementInfo& element) { return element.membrane; });
  Mesh mesh = generate(flat(lengths, cells, grading), kind);
  mesh.X.conservativeResizeLike(Eigen::MatrixXd::Zero(3, mesh.X.cols()));
  return mesh;
}

}  // namespace sim
