#include "sim/body/obstacle_nodes.h"

namespace sim {

namespace {

Eigen::MatrixXd nodes_of(const Plane& plane, bool moves, int D) {
  Eigen::MatrixXd X(D, moves ? 2 : 0);
  if (moves) X << plane.point.head(D), (plane.point + plane.normal.normalized()).head(D);
  return X;
}
Eigen::MatrixXd nodes_of(const Sphere& sphere, bool moves, int D) {
  Eigen::MatrixXd X(D, moves ? 1 : 0);
  if (moves) X << sphere.centre.head(D);
  return X;
}
Eigen::MatrixXd nodes_of(const RigidSurface& surface, bool /*moves*/, int /*D*/) {
  return surface.X;
}

Vec3 node_at(const Eigen::VectorXd& x, int node, int D) {
  Vec3 point = Vec3::Zero();
  point.head(D) = x.segment(static_cast<Eigen::Index>(node) * D, D);
  return point;
}

}  // namespace

Eigen::MatrixXd rest_nodes(const Obstacle& obstacle, int D) {
  const bool moves = !obstacle.motion.empty();
  return std::visit([&](const auto& shape) { return nodes_of(shape, moves, D); }, obstacle.shape);
}

Plane shape_at(const Plane& rest, const ObstacleNodes& nodes, const Eigen::VectorXd& x, int D) {
  if (nodes.count == 0) return rest;
  const Vec3 point = node_at(x, nodes.first, D);
  return {point, node_at(x, nodes.first + 1, D) - point};
}

Sphere shape_at(const Sphere& rest, const ObstacleNodes& nodes, const Eigen::VectorXd& x, int D) {
  return nodes.count == 0 ? rest : Sphere{node_at(x, nodes.first, D), rest.radius};
}

RigidSurface shape_at(const RigidSurface& rest, const ObstacleNodes& nodes, const Eigen::VectorXd& x, int D) {
  if (nodes.count == 0) return rest;
  return {x.segment(static_cast<Eigen::Index>(nodes.first) * D, static_cast<Eigen::Index>(nodes.count) * D)
              .reshaped(D, nodes.count),
          rest.faces};
}

}  // namespace sim
