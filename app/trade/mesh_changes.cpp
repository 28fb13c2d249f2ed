#include <algorithm>
#include <cmath>
#include <optional>

#include "app/scene/value_text.h"
#include "app/trade/lists.h"
#include "sim/element/element.h"
#include "sim/mesh/generate.h"

namespace app {
namespace {

// What becomes of a body's mesh: split so many times (-1: half the cells), with elements of this kind.
struct Change {
  int refine;
  int order;
  bool simplex;
};

// nullptr: there is none of this dimension.
const sim::ElementInfo* element_of(const Change& change, int dimension) {
  const auto found = std::ranges::find_if(sim::elements(), [&](const sim::ElementInfo& element) {
    return element.dimension == dimension && element.order == change.order && element.simplex() == change.simplex;
  });
  return found == sim::elements().end() ? nullptr : &*found;
}

// Whether this description of a mesh can be split so, with elements `to` instead of `from`.
bool possible(const MeshSpec& mesh, int refine, const sim::ElementInfo& from, const sim::ElementInfo* to) {
  const bool file = mesh.source == MeshSource::file || mesh.source == MeshSource::surface;
  if (!to || (file && to->simplex() != from.simplex())) return false;
  if (mesh.source == MeshSource::sheet && !to->membrane) return false;
  if (mesh.source == MeshSource::surface) return true;
  return mesh.refine + refine >= 0 || (!file && std::ranges::all_of(mesh.cells, [](int n) { return n >= 2; }));
}

double nodes_per_cell(const sim::ElementInfo& element) {
  return sim::elements_per_cell(element.kind) * element.nodes_per_element;
}

std::string list_text(const std::vector<int>& numbers) {
  std::string text;
  for (const int n : numbers) text += (text.empty() ? "" : ", ") + std::to_string(n);
  return "[" + text + "]";
}

void add_keys(const MeshSpec& mesh, int refine, std::string_view element, const std::string& body, TradeCase& which) {
  if (element != mesh.element) which = with(which, "", body + ".mesh.element", "\"" + std::string(element) + "\"");
  if (refine == 0) return;
  // Filled anew: splitting its cells would keep the steps with which they follow the surface.
  if (mesh.source == MeshSource::surface) {
    which = with(which, "", body + ".mesh.size", number_literal(std::ldexp(mesh.size, -refine)));
    return;
  }
  if (mesh.refine + refine >= 0) {
    which = with(which, "", body + ".mesh.refine", std::to_string(mesh.refine + refine));
  } else {
    std::vector<int> cells = mesh.cells;
    for (int& n : cells) n = (n + 1) / 2;
    which = with(which, "", body + ".mesh.cells", list_text(cells));
  }
}

std::string label(const MeshSpec& mesh, int refine, std::string_view element) {
  constexpr const char* split[] = {"half the cells, ", "", "cells split once, ", "cells split twice, "};
  constexpr const char* filled[] = {"size doubled, ", "", "size halved, ", "size quartered, "};
  return (mesh.source == MeshSource::surface ? filled : split)[refine + 1] + std::string(element);
}

std::optional<MeshChange> apply(const Document& scene, const Change& change) {
  MeshChange result{{"", Axis::mesh, {}}, 0, change.order == 2 && change.refine >= 0};
  for (std::size_t b = 0; b < scene.meshes.size(); ++b) {
    const MeshSpec& mesh = scene.meshes[b];
    const sim::ElementInfo& from = *sim::find_element(mesh.element);
    const sim::ElementInfo* const to = element_of(change, from.dimension);
    if (!possible(mesh, change.refine, from, to)) return std::nullopt;
    result.finest = result.finest && (change.refine > 0 || from.order == 1);
    add_keys(mesh, change.refine, to->name, "body." + std::to_string(b), result.change);
    result.change.label = label(mesh, change.refine, to->name);
    result.growth = std::max(
        result.growth, std::pow(2.0, from.dimension * change.refine) * nodes_per_cell(*to) / nodes_per_cell(from));
  }
  if (result.change.settings.empty()) return std::nullopt;
  result.change = in_all_nodes(scene, result.change);
  return result;
}

}  // namespace

std::vector<MeshChange> mesh_changes(const Document& scene) {
  std::vector<MeshChange> list;
  for (const int refine : {-1, 0, 1, 2})
    for (const auto& [order, simplex] :
         {std::pair(1, true), std::pair(1, false), std::pair(2, true), std::pair(2, false)}) {
      if (refine == 2 && order == 1) continue;  // only as a reference
      if (auto change = apply(scene, {refine, order, simplex})) list.push_back(std::move(*change));
    }
  std::ranges::stable_sort(list, {}, &MeshChange::growth);
  return list;
}

}  // namespace app
