// The surfaces that may touch, of all bodies of a contact one after the other: points, edges and flat faces, with what
// their share of the surface weighs. Faces are triangles; in the plane they are edges.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "sim/math/vec3.h"
#include "sim/mesh/mesh.h"
#include "sim/scene.h"

namespace sim {

// A run of numbers from first to last - 1.
struct Span {
  int first = 0, last = 0;
  int size() const { return last - first; }
};

struct Skin {
  // One body's share of every list.
  struct Part {
    Span points, edges, faces;
  };

  int D = 3;
  std::vector<int> node;  // of the system, for each point
  // A third of the triangles at it; in the plane half of the edges at it, times the thickness [m^2].
  std::vector<double> point_area;
  std::vector<int> faces_around;  // of a point inside the surface; 0 on the surface's rim

  // In space only.
  std::vector<std::array<int, 2>> edges;  // points
  std::vector<double> edge_area;          // a third of the triangles at it, m^2
  std::vector<double> edge_length;        // at rest, m
  std::vector<bool> edge_inside;          // it parts two faces

  std::vector<std::array<int, 3>> faces;       // points; in the plane the third is -1
  std::vector<std::array<int, 3>> face_edges;  // from the first point to the second and so on; none in the plane
  std::vector<Part> parts;

  int corners() const { return D; }  // of a face
};

// The flat faces of a mesh's surface, D nodes of the mesh each: the boundary of a solid or of a plane body, all of a
// membrane. Facets of four nodes are cut along the diagonal at the lowest node, quadratic ones at their middle nodes.
Eigen::MatrixXi flat_faces(const Mesh& mesh, int D);

// Adds a part; faces: nodes of the mesh, X: rest positions (D x nodes). first_node: number in the system of the mesh's
// first node; thickness [m] in the plane.
void add_part(Skin& skin, const Eigen::MatrixXi& faces, const Eigen::MatrixXd& X, int first_node, double thickness);
// The surface of a body.
void add_part(Skin& skin, const Body& body, int first_node);

}  // namespace sim
