// Where in a mesh: the element under a point, the nodes and boundary facets in a region.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "sim/math/vec3.h"
#include "sim/mesh/input_error.h"
#include "sim/mesh/mesh.h"
#include "sim/mesh/region.h"

namespace sim {

// A point that moves with the body: x = sum_i weights[i] x_(node i of the element).
struct MaterialPoint {
  int element = 0;
  std::vector<double> weights;  // N_i(xi), one per node of the element
};

// The material point at rest position X; empty when X is further than 1e-9 of the mesh size from every element.
std::optional<MaterialPoint> locate(const Mesh& mesh, const Vec3& X);

// What a group is asked for.
enum class GroupPart { nodes, facets, elements };

// The group of that name, and dimension where it is given. Of several of one name the one that has facets or elements,
// where these are asked for. Throws InputError (key "group") that lists the names there are, or those of one name.
const Group& find_group(const Mesh& mesh, const InGroup& where, GroupPart part);

// Nodes in the region, ascending; its surface counts as inside, to 1e-9 of the mesh size. In a plane mesh the third
// coordinate is ignored. May be empty. Throws as find_group.
std::vector<int> nodes_in(const Mesh& mesh, const Region& region);

// Boundary facets all of whose nodes are in the region, nodes per facet x facets, outward. For a group: the facets it
// names, or, when it names none, those between its nodes. Of a membrane: the group's elements, or all whose nodes are
// in the region; its edges only where there are none. May be empty. Throws as find_group.
Eigen::MatrixXi facets_in(const Mesh& mesh, const Region& region);

// For messages: "it spans [0, 0, 0] to [4, 1, 1] m".
std::string span_text(const Mesh& mesh);

}  // namespace sim
