#include "app/scene/body_mesh.h"

#include <cmath>
#include <optional>
#include <tuple>

#include "app/base/text.h"
#include "app/mesh/error.h"
#include "app/mesh/mesh_file.h"
#include "sim/element/element.h"
#include "sim/fill/fill.h"
#include "sim/mesh/check.h"
#include "sim/mesh/components.h"
#include "sim/mesh/generate.h"
#include "sim/mesh/input_error.h"
#include "sim/mesh/merge.h"
#include "sim/mesh/quadratic.h"
#include "sim/mesh/refine.h"
#include "sim/mesh/transform.h"

namespace app {
namespace {

using sim::ElementKind;
using sim::InputError;

// A larger mesh is taken for a slip of the pen: its matrix alone would fill 20 GB.
constexpr double most_elements = 2e7;

void check_count(double elements, const std::string& key) {
  if (elements > most_elements) throw InputError(key, "makes more than 2e7 elements");
}

void check_axes(const MeshSpec& spec) {
  const std::size_t count = axes(spec.source);
  const std::string right = "must have " + std::to_string(count) + " numbers, one per axis";
  if (spec.cells.empty()) throw InputError("mesh", "'cells' is missing: the number of cells per axis");
  if (spec.cells.size() != count) throw InputError("mesh.cells", right);
  if (spec.grading.size() != count) throw InputError("mesh.grading", right);
  double cells = 1;
  for (const int n : spec.cells) cells *= n;
  check_count(cells, "mesh.cells");
}

sim::Mesh generate(const MeshSpec& spec) {
  const ElementKind kind = sim::find_element(spec.element)->kind;
  const auto& [x, n, g] = std::tie(spec.lengths, spec.cells, spec.grading);
  switch (spec.source) {
    case MeshSource::box:
      return sim::generate_box({x[0], x[1], x[2]}, {n[0], n[1], n[2]}, {g[0], g[1], g[2]}, kind);
    case MeshSource::rectangle:
      return sim::generate_rectangle({x[0], x[1]}, {n[0], n[1]}, {g[0], g[1]}, kind);
    default:
      return sim::generate_sheet({x[0], x[1]}, {n[0], n[1]}, {g[0], g[1]}, kind);
  }
}

// The element that was asked for, when it is the quadratic kind of what the file holds.
sim::Mesh as_asked(sim::Mesh mesh, const MeshSpec& spec) {
  const ElementKind asked = spec.element.empty() ? mesh.kind : sim::find_element(spec.element)->kind;
  const std::string held(sim::info(mesh.kind).name);
  if (asked != mesh.kind && sim::info(asked).linear == mesh.kind) mesh = sim::to_quadratic(mesh);
  if (mesh.kind != asked) throw InputError("mesh.element", "the file holds " + held + " elements");
  return mesh;
}

void add_remark(std::vector<std::string>& remarks, int count, const std::string& what) {
  if (count > 0) remarks.push_back(std::to_string(count) + " " + what);
}

// Nodes that stand where others do are joined where the scene asks for it, else counted: the body may fall apart there.
void merge_nodes(const MeshSpec& spec, sim::Mesh& mesh, std::vector<std::string>& remarks) {
  const double distance = spec.merge > 0 ? spec.merge : sim::coincidence(mesh);
  if (spec.merge < 0) {
    const int count = spec.source == MeshSource::file ? sim::count_coincident(mesh, distance) : 0;
    if (count == 0) return;
    remarks.push_back(std::to_string(count) + " nodes stand where others do, and the body is in " +
                      std::to_string(sim::components(mesh).size()) + " parts; mesh.merge = true joins them");
    return;
  }
  const sim::Joined joined = sim::join_coincident(mesh, distance);
  if (mesh.element_count() == 0) throw InputError("mesh.merge", "joins the nodes of every element");
  remarks.push_back(std::to_string(joined.nodes) + " nodes joined with others; the body is in " +
                    std::to_string(sim::components(mesh).size()) + " parts");
  add_remark(remarks, joined.elements, "elements had two nodes that were joined and have been left out");
}

// The tets inside a closed surface.
sim::Mesh filled_surface(const MeshSpec& spec, const sim::Mesh& surface, std::vector<std::string>& remarks) {
  if (surface.kind != ElementKind::tri3 || surface.dimension() != 3)
    throw InputError("mesh.surface", "is no surface of triangles in space; mesh.file reads what it is");
  if (spec.size == 0)
    throw InputError("mesh", "'size' is missing: about the length of the edges that fill the surface");
  sim::Filling filling = sim::fill(surface, spec.size / spec.scale);
  const sim::Shells& shells = filling.shells;
  remarks.push_back("filled " + std::to_string(surface.element_count()) + " triangles with " +
                    std::to_string(filling.mesh.element_count()) + " tets; smallest dihedral angle " +
                    formatted("%.1f", filling.smallest_angle) + " degrees");
  if (shells.count > 1) remarks.push_back("the surface is in " + std::to_string(shells.count) + " shells");
  add_remark(remarks, shells.open_edges, "edges of the surface are open; the holes have been closed");
  add_remark(remarks, shells.crowded_edges, "edges of the surface have more than two triangles");
  add_remark(remarks, shells.turned, "triangles faced the other way than their neighbours and have been turned");
  add_remark(remarks, shells.inside_out, "shells were inside out and have been turned");
  add_remark(remarks, shells.cavities, "shells inside of others are walls of cavities");
  add_remark(remarks, filling.crumbs, "parts smaller than 1 % of the largest one have been left out");
  add_remark(remarks, filling.lost, "parts of the surface are thinner than mesh.size, and nothing is filled there");
  const std::size_t parts = sim::components(filling.mesh).size();
  if (parts > 1) remarks.push_back("the body is in " + std::to_string(parts) + " parts that nothing connects");
  if (spec.wears_surface && shells.open_edges > 0)
    remarks.push_back("mesh.skin shows the surface as it came, holes and all");
  constexpr double half = 0.5;
  if (filling.spanned < half)
    remarks.push_back("the body is " + percent(filling.spanned) +
                      " as long as the surface; the rest encloses nothing, or nothing as large as mesh.size");
  return std::move(filling.mesh);
}

// A surface or a file of tets as the scene asks for it.
sim::Mesh read_body(MeshSpec& spec, std::optional<sim::Mesh>& surface, std::vector<std::string>& remarks) {
  if (!spec.cells.empty()) throw InputError("mesh.cells", "is for generated meshes only");
  if (!spec.grading.empty()) throw InputError("mesh.grading", "is for generated meshes only");
  sim::Mesh mesh = read_mesh(spec.file, remarks);
  if (spec.source == MeshSource::file) return as_asked(std::move(mesh), spec);
  surface = std::move(mesh);
  return as_asked(filled_surface(spec, *surface, remarks), spec);
}

// The surface that the body wears, on the tets as they have become.
void put_skin_on(MeshSpec& spec, std::optional<sim::Mesh> surface, const sim::Mesh& mesh) {
  if (spec.wears_surface && !surface) throw InputError("mesh.skin", "true is for a body that is filled: mesh.surface");
  if (!spec.skin_file.empty()) {
    std::vector<std::string> unsaid;  // of a file that is only looked at
    try {
      surface = read_mesh(spec.skin_file, unsaid);
    } catch (const FileError& error) {
      throw InputError("mesh.skin", error.what());
    }
  }
  if (spec.wears_surface || !spec.skin_file.empty())
    spec.skin = std::make_shared<const Skin>(make_skin(*surface, mesh));
}

void into_space(sim::Mesh& mesh) {
  if (mesh.dimension() == 3) return;
  const sim::ElementInfo& element = sim::info(mesh.kind);
  if (!element.membrane) throw InputError("mesh.element", std::string(element.name) + " is for 2D scenes only");
  mesh.X.conservativeResize(3, Eigen::NoChange);
  mesh.X.row(2).setZero();
}

}  // namespace

int axes(MeshSource source) {
  return source == MeshSource::box ? 3 : 2;
}

sim::Mesh make_mesh(MeshSpec& spec, std::vector<std::string>& remarks) {
  sim::Mesh mesh;
  std::optional<sim::Mesh> surface;
  if (spec.source != MeshSource::surface && spec.size != 0)
    throw InputError("mesh.size", "is for a surface that is filled: mesh.surface");
  if (spec.source == MeshSource::file || spec.source == MeshSource::surface) {
    mesh = read_body(spec, surface, remarks);
  } else {
    if (spec.element.empty()) spec.element = spec.source == MeshSource::box ? "tet4" : "tri3";
    if (spec.grading.empty()) spec.grading.assign(axes(spec.source), 1.0);
    check_axes(spec);
    mesh = generate(spec);
  }
  spec.element = sim::info(mesh.kind).name;
  merge_nodes(spec, mesh, remarks);

  const sim::MeshCheck check = sim::check_and_orient(mesh);
  add_remark(remarks, check.reoriented, "elements were inside out and have been turned");
  add_remark(remarks, check.dropped_nodes, "nodes of no element have been dropped");
  add_remark(remarks, check.dropped_facets, "facets of groups lie on no element and have been dropped");
  const double children = sim::info(mesh.kind).dimension == 2 ? 4 : 8;
  check_count(mesh.element_count() * std::pow(children, spec.refine), "mesh.refine");
  for (int i = 0; i < spec.refine; ++i) mesh = sim::refine(mesh);
  if (spec.space == 3) into_space(mesh);
  put_skin_on(spec, std::move(surface), mesh);
  return mesh;
}

void place_mesh(const MeshSpec& spec, int dimension, sim::Mesh& mesh) {
  if (dimension == 3) into_space(mesh);
  if (spec.scale != 1) sim::scale(mesh, sim::Vec3::Constant(spec.scale));
  if (spec.degrees != 0) sim::rotate(mesh, spec.axis, spec.degrees);
  sim::translate(mesh, spec.translate);
}

}  // namespace app
