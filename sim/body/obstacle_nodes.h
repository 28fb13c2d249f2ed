// The nodes that an obstacle has in the system: prescribed ones, behind those of all bodies. A surface has its own. Of
// what moves, a sphere has its centre, and a plane a point and the end of the normal at it. What stands still and is no
// surface has none.
#pragma once

#include <Eigen/Core>

#include "sim/scene.h"

namespace sim {

struct ObstacleNodes {
  int first = 0, count = 0;
};

// Where they are without the obstacle's motion, D numbers each.
Eigen::MatrixXd rest_nodes(const Obstacle& obstacle, int D);

// The shape where the nodes are at x, all positions of the system.
Plane shape_at(const Plane& rest, const ObstacleNodes& nodes, const Eigen::VectorXd& x, int D);
Sphere shape_at(const Sphere& rest, const ObstacleNodes& nodes, const Eigen::VectorXd& x, int D);
RigidSurface shape_at(const RigidSurface& rest, const ObstacleNodes& nodes, const Eigen::VectorXd& x, int D);

}  // namespace sim
