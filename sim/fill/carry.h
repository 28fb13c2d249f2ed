// Points that ride on a mesh of tets, inside or near to it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/mesh/locate.h"
#include "sim/mesh/mesh.h"

namespace sim {

// For each point the tet that holds it or, outside, the one among those near to it that holds it best, with the
// barycentric coordinates as weights of its four corners (below 0 outside): x = sum_i weights[i] x_(corner i). Affine
// motions of the body take the points along exactly. Elements are tets of either order.
std::vector<MaterialPoint> carry(const Mesh& mesh, const Eigen::Matrix3Xd& points);

// By how much of its element's height a point is outside at most; 0 inside.
double farthest_outside(const std::vector<MaterialPoint>& points);

}  // namespace sim
