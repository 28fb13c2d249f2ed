#include "sim/study/body_motion.h"

#include <Eigen/Geometry>

#include "sim/build/parts.h"

namespace sim {

namespace {

Vec3 place(const Eigen::VectorXd& x, Eigen::Index node, int D) {
  Vec3 at = Vec3::Zero();
  at.head(D) = x.segment(node * D, D);
  return at;
}

}  // namespace

Momentum momentum(const System& system, const State& state, std::size_t body) {
  const Model& model = parts_of(system).model;
  const Mass& mass = model.masses[body];
  const int D = model.D;
  Eigen::VectorXd p = Eigen::VectorXd::Zero(model.dofs());
  mass.add_product(1, state.v, p, D);
  Momentum sum;
  Vec3 centre = Vec3::Zero();
  for (Eigen::Index i = 0; i < mass.nodal().size(); ++i)
    centre += mass.nodal()[i] / mass.total() * place(state.x, mass.first_node() + i, D);
  for (Eigen::Index i = 0; i < mass.nodal().size(); ++i) {
    const Vec3 of_node = place(p, mass.first_node() + i, D);
    sum.linear += of_node;
    sum.angular += (place(state.x, mass.first_node() + i, D) - centre).cross(of_node);
  }
  return sum;
}

ModalMotion modal_motion(const System& system, const State& state, std::size_t body, const Eigen::VectorXd& psi) {
  const Model& model = parts_of(system).model;
  const Eigen::Index first = Eigen::Index{model.D} * model.ranges[body].first_node;
  Eigen::VectorXd M_psi = Eigen::VectorXd::Zero(model.dofs()), whole = M_psi;
  whole.segment(first, psi.size()) = psi;
  model.masses[body].add_product(1, whole, M_psi, model.D);
  return {M_psi.dot(state.x - model.X), M_psi.dot(state.v)};
}

}  // namespace sim
