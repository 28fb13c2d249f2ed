#include <algorithm>
#include <cmath>
#include <optional>

#include "app/trade/lists.h"
#include "sim/element/element.h"

namespace app {
namespace {

enum class Shape { linear, quadratic, brick };

// What becomes of a body's mesh: split so many times (-1: half the cells), with elements of this shape.
struct Change {
  int refine;
  Shape shape;
};

Shape shape_of(const std::string& element) {
  if (element == "quad4" || element == "hex8") return Shape::brick;
  return element == "tri6" || element == "tet10" ? Shape::quadratic : Shape::linear;
}

std::string element_of(Shape shape, int dimension) {
  constexpr const char* names[2][3] = {{"tri3", "tri6", "quad4"}, {"tet4", "tet10", "hex8"}};
  return names[dimension - 2][static_cast<int>(shape)];
}

// Whether this description of a mesh can be changed so.
bool possible(const MeshSpec& mesh, const Change& change) {
  const bool file = mesh.source == MeshSource::file;
  if (file && (change.shape == Shape::brick) != (shape_of(mesh.element) == Shape::brick)) return false;
  if (mesh.source == MeshSource::sheet && change.shape == Shape::brick) return false;
  if (mesh.refine + change.refine >= 0) return true;
  return !file && std::ranges::all_of(mesh.cells, [](int n) { return n >= 2; });
}

// Nodes for each element, about, of a large mesh.
double nodes_per_element(Shape shape, int dimension) {
  constexpr double nodes[2][3] = {{0.5, 2, 1}, {0.18, 1.37, 1}};
  return nodes[dimension - 2][static_cast<int>(shape)];
}

// A cell is cut into 2 triangles or 6 tets.
double elements_per_cell(Shape shape, int dimension) {
  return shape == Shape::brick ? 1 : dimension == 2 ? 2 : 6;
}

std::string list_text(const std::vector<int>& numbers) {
  std::string text;
  for (const int n : numbers) text += (text.empty() ? "" : ", ") + std::to_string(n);
  return "[" + text + "]";
}

void add_keys(const MeshSpec& mesh, const Change& change, const std::string& body, int dimension, TradeCase& which) {
  const std::string element = element_of(change.shape, dimension);
  if (element != mesh.element) which = with(which, "", body + ".mesh.element", "\"" + element + "\"");
  if (change.refine == 0) return;
  if (mesh.refine + change.refine >= 0) {
    which = with(which, "", body + ".mesh.refine", std::to_string(mesh.refine + change.refine));
  } else {
    std::vector<int> cells = mesh.cells;
    for (int& n : cells) n = (n + 1) / 2;
    which = with(which, "", body + ".mesh.cells", list_text(cells));
  }
}

std::string label(const Change& change, int dimension) {
  const std::string element = element_of(change.shape, dimension);
  if (change.refine < 0) return "half the cells, " + element;
  if (change.refine == 0) return element;
  return "cells split " + std::string(change.refine == 1 ? "once" : "twice") + ", " + element;
}

std::optional<MeshChange> apply(const Document& scene, const Change& change) {
  MeshChange result{{"", Axis::mesh, {}}, 0, change.shape == Shape::quadratic && change.refine >= 0};
  for (std::size_t b = 0; b < scene.meshes.size(); ++b) {
    const MeshSpec& mesh = scene.meshes[b];
    if (!possible(mesh, change)) return std::nullopt;
    const int dimension = sim::find_element(mesh.element)->dimension;
    const Shape old = shape_of(mesh.element);
    result.finest = result.finest && (change.refine > 0 || old != Shape::quadratic);
    add_keys(mesh, change, "body." + std::to_string(b), dimension, result.change);
    result.change.label = label(change, dimension);
    const double cells = elements_per_cell(change.shape, dimension) / elements_per_cell(old, dimension);
    result.growth =
        std::max(result.growth, std::pow(2.0, dimension * change.refine) * cells *
                                    nodes_per_element(change.shape, dimension) / nodes_per_element(old, dimension));
  }
  if (result.change.settings.empty()) return std::nullopt;
  return result;
}

}  // namespace

std::vector<MeshChange> mesh_changes(const Document& scene) {
  std::vector<MeshChange> list;
  for (const int refine : {-1, 0, 1, 2})
    for (const Shape shape : {Shape::linear, Shape::brick, Shape::quadratic}) {
      if (refine == 2 && shape != Shape::quadratic) continue;  // only as a reference
      if (auto change = apply(scene, {refine, shape})) list.push_back(std::move(*change));
    }
  std::ranges::stable_sort(list, {}, &MeshChange::growth);
  return list;
}

}  // namespace app
