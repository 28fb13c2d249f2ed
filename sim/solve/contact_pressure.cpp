#include "sim/solve/contact_pressure.h"

#include <Eigen/Geometry>

namespace sim {

namespace {

// Of the surface at rest, a third of each face for its points; in the plane half of each edge, times the thickness.
void add_areas(const Body& body, int first_node, int D, Eigen::VectorXd& area) {
  const Eigen::MatrixXi faces = flat_faces(body.mesh, D);
  for (const auto& face : faces.colwise()) {
    const Eigen::VectorXd edge = body.mesh.X.col(face[1]) - body.mesh.X.col(face[0]);
    double whole = edge.norm() * body.thickness;
    if (D == 3) whole = Vec3(edge).cross(Vec3(body.mesh.X.col(face[2]) - body.mesh.X.col(face[0]))).norm() / 2;
    for (const int node : face) area[first_node + node] += whole / D;
  }
}

}  // namespace

Eigen::VectorXd contact_pressure(const Model& model, const Motion& motion) {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(model.dofs()), area = Eigen::VectorXd::Zero(model.node_count);
  // A store whose step has not begun knows no friction.
  for (const ContactTerm* term : model.contacts) term->add_forces(motion, *term->make_store(1), f);
  for (const ObstacleTerm* term : model.smooth) term->add_forces(motion, *term->make_store(1), f);
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    add_areas(model.bodies[b], model.ranges[b].first_node, model.D, area);
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(model.node_count);
  for (int node = 0; node < model.node_count; ++node)
    if (area[node] > 0)
      pressure[node] = f.segment(static_cast<Eigen::Index>(node) * model.D, model.D).norm() / area[node];
  return pressure;
}

}  // namespace sim
