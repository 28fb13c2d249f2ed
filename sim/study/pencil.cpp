#include "sim/study/pencil.h"

#include "sim/build/parts.h"
#include "sim/solve/tangent_operator.h"

namespace sim {

Scene at_rest_alone(const Scene& scene, std::size_t number) {
  Scene one;
  one.dimension = scene.dimension;
  one.world.gravity.setZero();
  one.solver.linear = LinearSolverKind::cholmod;
  one.bodies = {scene.bodies[number]};
  Body& body = one.bodies[0];
  body.start = {};
  body.damping = {};
  body.loads = {};
  body.untangle = 0;
  body.basis.reset();
  return one;
}

Pencil::Pencil(const System& system) {
  const Model& model = parts_of(system).model;
  TangentOperator tangent(model, 1);
  model.pins.mark(0, tangent.free());
  free = tangent.free();
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(model.dofs());
  Eigen::VectorXd f(model.dofs());
  tangent.begin_step({model.X, still, 0, 0});
  tangent.linearise({model.X, still, 0, 0}, 0, Definiteness::none, f);
  BlockMatrix stiffness(*model.pattern, model.D), mass(*model.pattern, model.D);
  tangent.assemble(stiffness);
  for (const Mass& m : model.masses) m.add_matrix(1, mass);
  K = free_part(stiffness, free);
  M = free_part(mass, free);
}

}  // namespace sim
