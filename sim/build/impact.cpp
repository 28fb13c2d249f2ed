#include "sim/build/impact.h"

#include <algorithm>
#include <limits>

#include "sim/body/pose.h"

namespace sim {

namespace {

// Speed is convex in the place, so it is largest at a corner of the box around these nodes.
double fastest(const Model& model, int first_node, int count, const std::vector<Keyframe>& motion) {
  if (motion.empty()) return 0;
  const auto X =
      model.X.segment(static_cast<Eigen::Index>(first_node) * model.D, static_cast<Eigen::Index>(count) * model.D)
          .reshaped(model.D, count);
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  low.head(model.D) = X.rowwise().minCoeff();
  high.head(model.D) = X.rowwise().maxCoeff();
  double speed = 0;
  for (const Keyframe& keyframe : motion) {
    const Pose pose(motion, keyframe.t);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 at(corner & 1 ? low[0] : high[0], corner & 2 ? low[1] : high[1], corner & 4 ? low[2] : high[2]);
      speed = std::max(speed, pose.velocity(pose.place(at)).norm());
    }
  }
  return speed;
}

}  // namespace

double speed_of_body(const Parts& parts, std::size_t b) {
  if (parts.scheme->is_static) return 0;
  const Body& body = parts.model.bodies[b];
  const BodyRange& range = parts.model.ranges[b];
  double speed = body.velocity.norm() + std::abs(body.spin.rate) * range.size / 2;
  for (const Pin& pin : body.pins)
    speed = std::max(speed, fastest(parts.model, range.first_node, range.node_count, pin.motion));
  return speed;
}

double speed_of_obstacle(const Parts& parts, std::size_t k) {
  const ObstacleNodes& nodes = parts.model.obstacle_nodes[k];
  if (parts.scheme->is_static || nodes.count == 0) return 0;
  return fastest(parts.model, nodes.first, nodes.count, parts.model.obstacles[k].motion);
}

double barrier_stiffness(const Body& body, double speed) {
  constexpr double of_young = 0.1, of_impact = 0.1;
  double young = std::numeric_limits<double>::infinity(), density = 0;
  for (const MaterialSpec& material : body.materials) {
    young = std::min(young, material.young);
    density = std::max(density, material.density);
  }
  return std::max(of_young * young, of_impact * density * speed * speed);
}

}  // namespace sim
