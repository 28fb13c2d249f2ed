// Shape functions of the elements of a mesh, looked at from outside, and what nodal interpolation with them leaves out.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/mesh/mesh.h"

namespace sim {

// A point of a plane element in its own coordinates: (r, s) of a triangle, [-1,1]^2 of a quadrilateral.
struct PointOfElement {
  int element = 0;
  Eigen::Vector2d xi = {0, 0};
};

struct ShapeValues {
  Eigen::Vector2d X;      // m: where the point is
  Eigen::VectorXd N;      // of the element's nodes
  Eigen::MatrixXd dN_dX;  // 1/m, nodes x 2
};
ShapeValues shape_values(const Mesh& mesh, const PointOfElement& at);

// The element that holds X, or whose edge is nearest, and where it does. Straight edges.
PointOfElement find_point_of_element(const Mesh& mesh, const Eigen::Vector2d& X);

// The element cut into small triangles or quadrilaterals, `pieces` along an edge: the corners of each.
std::vector<std::vector<PointOfElement>> facets_of_element(const Mesh& mesh, int element, int pieces);

// Nodal interpolation of u(x, y) = sin(pi x) e^y: nodes have its values, elements what their shape functions make of
// them.
struct InterpolationError {
  double L2 = 0, H1_seminorm = 0;
  double max = 0;  // over 41 x 41 points of every quadrilateral, 861 of every triangle
};
InterpolationError interpolation_error(const Mesh& mesh);
double interpolated(const Eigen::Vector2d& X);  // u itself

}  // namespace sim
