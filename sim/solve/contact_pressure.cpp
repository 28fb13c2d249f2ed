#include "sim/solve/contact_pressure.h"

namespace sim {

Eigen::VectorXd contact_pressure(const Model& model, const Motion& motion) {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(model.dofs());
  // A store whose step has not begun knows no friction.
  for (const ContactTerm* term : model.contacts) term->add_forces(motion, *term->make_store(1), f);
  for (const ObstacleTerm* term : model.smooth) term->add_forces(motion, *term->make_store(1), f);
  Skin skin;
  skin.D = model.D;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) add_part(skin, model.bodies[b], model.ranges[b].first_node);
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(model.node_count);
  for (std::size_t p = 0; p < skin.node.size(); ++p)
    if (skin.point_area[p] > 0)
      pressure[skin.node[p]] =
          f.segment(static_cast<Eigen::Index>(skin.node[p]) * model.D, model.D).norm() / skin.point_area[p];
  return pressure;
}

}  // namespace sim
