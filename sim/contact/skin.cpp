#include "sim/contact/skin.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <span>

#include "sim/element/element.h"
#include "sim/mesh/boundary.h"

namespace sim {

namespace {

using Corners = std::array<int, 3>;  // local nodes of a flat face; in the plane the third is not used

// The flat faces of one facet of a mesh, by its local nodes.
std::span<const Corners> cut(const int* nodes, Eigen::Index count, int D) {
  static constexpr Corners whole[] = {{0, 1, 2}};
  static constexpr Corners halves[] = {{0, 2, -1}, {2, 1, -1}};  // an edge at its middle node
  static constexpr Corners quarters[] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
  static constexpr Corners along_02[] = {{0, 1, 2}, {0, 2, 3}}, along_13[] = {{0, 1, 3}, {1, 2, 3}};
  if (D == 2) return count == 3 ? std::span<const Corners>(halves) : std::span<const Corners>(whole);
  if (count == 6) return quarters;
  if (count != 4) return whole;
  const auto lowest = std::min_element(nodes, nodes + 4) - nodes;
  return lowest % 2 == 0 ? along_02 : along_13;
}

}  // namespace

Eigen::MatrixXi flat_faces(const Mesh& mesh, int D) {
  const Eigen::MatrixXi facets = D == 2 ? boundary_facets(mesh) : surface_facets(mesh);
  std::vector<int> flat;
  for (Eigen::Index f = 0; f < facets.cols(); ++f) {
    const int* nodes = facets.data() + f * facets.rows();
    for (const Corners& corners : cut(nodes, facets.rows(), D))
      for (int i = 0; i < D; ++i) flat.push_back(nodes[corners[i]]);
  }
  return Eigen::Map<const Eigen::MatrixXi>(flat.data(), D, static_cast<Eigen::Index>(flat.size()) / D);
}

namespace {

// Gives points their numbers and faces their points.
void add_points(Skin& skin, const Eigen::MatrixXi& faces, int first_node) {
  std::vector<int> nodes(faces.data(), faces.data() + faces.size());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  const int first = static_cast<int>(skin.node.size());
  for (const int node : nodes) skin.node.push_back(first_node + node);
  for (Eigen::Index f = 0; f < faces.cols(); ++f) {
    std::array<int, 3> points = {-1, -1, -1};
    for (int i = 0; i < skin.D; ++i)
      points[i] = first + static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), faces(i, f)) - nodes.begin());
    skin.faces.push_back(points);
  }
}

// Edges of the faces from `part` on, in the order in which the faces name them.
void add_edges(Skin& skin, const Skin::Part& part) {
  std::map<std::array<int, 2>, int> numbers;
  std::vector<int> uses;
  for (int f = part.faces.first; f < part.faces.last; ++f) {
    std::array<int, 3> edges;
    for (int i = 0; i < 3; ++i) {
      const int a = skin.faces[f][i], b = skin.faces[f][(i + 1) % 3];
      const std::array<int, 2> ends = {std::min(a, b), std::max(a, b)};
      const auto [at, is_new] = numbers.try_emplace(ends, static_cast<int>(skin.edges.size()));
      if (is_new) {
        skin.edges.push_back(ends);
        uses.push_back(0);
      }
      edges[i] = at->second;
      ++uses[at->second - part.edges.first];
    }
    skin.face_edges.push_back(edges);
  }
  for (const int count : uses) skin.edge_inside.push_back(count > 1);
}

// Points with an edge (in the plane: themselves) that has one face only are on the rim.
void find_rim(Skin& skin, const Skin::Part& part) {
  skin.faces_around.resize(skin.node.size(), 0);
  for (int f = part.faces.first; f < part.faces.last; ++f)
    for (int i = 0; i < skin.corners(); ++i) ++skin.faces_around[skin.faces[f][i]];
  for (int e = part.edges.first; e < part.edges.last; ++e)
    if (!skin.edge_inside[e])
      for (const int point : skin.edges[e]) skin.faces_around[point] = 0;
  if (skin.D == 2)
    for (int p = part.points.first; p < part.points.last; ++p)
      if (skin.faces_around[p] < 2) skin.faces_around[p] = 0;
}

}  // namespace

void add_part(Skin& skin, const Eigen::MatrixXi& faces, const Eigen::MatrixXd& X, int first_node, double thickness) {
  const auto size = [](const auto& list) { return static_cast<int>(list.size()); };
  Skin::Part part;
  part.points.first = size(skin.node);
  part.edges.first = size(skin.edges);
  part.faces.first = size(skin.faces);
  add_points(skin, faces, first_node);
  part.faces.last = size(skin.faces);
  if (skin.D == 3) add_edges(skin, part);
  part.points.last = size(skin.node);
  part.edges.last = size(skin.edges);
  find_rim(skin, part);
  const auto place = [&](int point) {
    Vec3 x = Vec3::Zero();
    x.head(skin.D) = X.col(skin.node[point] - first_node).head(skin.D);
    return x;
  };
  skin.point_area.resize(skin.node.size(), 0);
  skin.edge_area.resize(skin.edges.size(), 0);
  for (int e = part.edges.first; e < part.edges.last; ++e)
    skin.edge_length.push_back((place(skin.edges[e][0]) - place(skin.edges[e][1])).norm());
  for (int f = part.faces.first; f < part.faces.last; ++f) {
    const auto& [a, b, c] = skin.faces[f];
    const Vec3 edge = place(b) - place(a);
    const double area = skin.D == 2 ? edge.norm() * thickness : 0.5 * edge.cross(place(c) - place(a)).norm();
    for (int i = 0; i < skin.corners(); ++i) skin.point_area[skin.faces[f][i]] += area / skin.corners();
    if (skin.D == 3)
      for (const int e : skin.face_edges[f]) skin.edge_area[e] += area / 3;
  }
  skin.parts.push_back(part);
}

void add_part(Skin& skin, const Body& body, int first_node) {
  add_part(skin, flat_faces(body.mesh, skin.D), body.mesh.X, first_node, body.thickness);
}

}  // namespace sim
