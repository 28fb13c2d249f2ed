#include "app/mesh/msh_mesh.h"

#include <algorithm>

#include "app/mesh/error.h"
#include "app/mesh/mesh_nodes.h"
#include "app/mesh/msh_cut.h"
#include "app/mesh/msh_groups.h"

namespace app {
namespace {

// The one type of the elements of the highest dimension.
const MshType& body_type(const MshContents& contents, const std::string& name) {
  std::map<const MshType*, std::size_t> count;
  int dimension = 0;
  for (const MshBlock& block : contents.blocks) {
    if (block.nodes.empty()) continue;
    if (block.type->dimension > dimension) count.clear();
    dimension = std::max(dimension, block.type->dimension);
    if (block.type->dimension == dimension) {
      count[block.type] += block.nodes.size() / static_cast<std::size_t>(block.type->nodes);
    }
  }
  if (dimension < 2) {
    throw FileError(name + ": there are no triangles, squares, tets or hexes in it; a body is made of these " +
                    "(gmsh -2 or gmsh -3 makes them)");
  }
  std::string kinds;
  for (const auto& [type, n] : count) {
    kinds += (kinds.empty() ? "" : " and ") + std::to_string(n) + " " + std::string(type->name);
  }
  if (count.size() > 1) throw FileError(name + ": the body is made of " + kinds + "; it should be of one kind");
  const MshType& type = *count.begin()->first;
  if (!type.element) {
    throw FileError(name + ": the body is made of " + kinds + "; it should be " +
                    sim::element_list([](const sim::ElementInfo&) { return true; }));
  }
  return type;
}

// The elements of the body, in the order of the file.
Eigen::MatrixXi body_elements(const MshContents& contents, const MshType& type) {
  std::vector<int> nodes;
  for (const MshBlock& block : contents.blocks) {
    if (block.type == &type) nodes.insert(nodes.end(), block.nodes.begin(), block.nodes.end());
  }
  const auto count = static_cast<Eigen::Index>(nodes.size()) / type.nodes;
  Eigen::MatrixXi elements = Eigen::Map<const Eigen::MatrixXi>(nodes.data(), type.nodes, count);
  const std::span<const int> order = type.element->gmsh_order;
  return order.empty() ? elements : Eigen::MatrixXi(elements(order, Eigen::indexing::all));
}

// The groups of each element of the body.
std::vector<const std::vector<int>*> body_groups(const MshContents& contents, const MshType& type) {
  std::vector<const std::vector<int>*> groups;
  for (const MshBlock& block : contents.blocks) {
    if (block.type != &type) continue;
    groups.insert(groups.end(), block.nodes.size() / static_cast<std::size_t>(type.nodes), &block.physical);
  }
  return groups;
}

// MSH 2 writes an element once for each of its groups: it becomes one element in several groups. A second one in the
// same groups is a fault of the mesh, mended and told. Returns the new index of each element.
std::vector<int> merge_repeated(sim::Mesh& mesh, const std::vector<const std::vector<int>*>& groups,
                                const std::string& name, std::vector<std::string>& remarks) {
  const std::vector<int> first = first_equal_column(mesh.elements);
  std::vector<int> index(first.size());
  int count = 0, repeated = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const auto original = static_cast<std::size_t>(first[i]);
    if (original != i) {
      index[i] = index[original];
      repeated += *groups[i] == *groups[original];
    } else {
      mesh.elements.col(count) = mesh.elements.col(static_cast<Eigen::Index>(i));
      index[i] = count++;
    }
  }
  mesh.elements.conservativeResize(Eigen::NoChange, count);
  if (repeated > 0) {
    remarks.push_back(name + ": elements that repeat others, left out: " + std::to_string(repeated));
  }
  return index;
}

}  // namespace

sim::Mesh make_mesh(MshContents contents, const std::string& name, std::vector<std::string>& remarks) {
  cut_squares_beside_triangles(contents, name, remarks);
  const MshType& type = body_type(contents, name);
  sim::Mesh mesh;
  mesh.kind = type.element->kind;
  mesh.X = Eigen::Map<const Eigen::MatrixXd>(contents.coordinates.data(), 3,
                                             static_cast<Eigen::Index>(contents.coordinates.size() / 3));
  mesh.elements = body_elements(contents, type);
  MshIndex index{&type, {}, {}};
  index.elements = merge_repeated(mesh, body_groups(contents, type), name, remarks);
  index.nodes = keep_used_nodes(mesh, name, remarks);
  flatten(mesh, name);
  mesh.groups = make_groups(contents, index, name, remarks);
  return mesh;
}

}  // namespace app
