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

namespace {

// K and M of all components, and which of them are free.
struct WholePencil {
  BlockMatrix stiffness, mass;
  Eigen::VectorXd free;

  explicit WholePencil(const Model& model)
      : stiffness(*model.pattern, model.D), mass(*model.pattern, model.D), free(model.dofs()) {
    TangentOperator tangent(model, 1);
    model.pins.mark(0, free);
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(model.dofs());
    Eigen::VectorXd f(model.dofs());
    tangent.begin_step({model.X, still, 0, 0});
    tangent.linearise({model.X, still, 0, 0}, 0, Definiteness::none, f);
    tangent.assemble(stiffness);
    for (const Mass& m : model.masses) m.add_matrix(1, mass);
  }
};

}  // namespace

Pencil::Pencil(const System& system) {
  const WholePencil whole(parts_of(system).model);
  free = whole.free;
  K = free_part(whole.stiffness, free);
  M = free_part(whole.mass, free);
}

PencilFactor::PencilFactor(const System& system, double shift) {
  WholePencil whole(parts_of(system).model);
  LargeArray<double>& K = whole.stiffness.values();
  for (std::size_t k = 0; k < K.size(); ++k) K[k] += shift * whole.mass.values()[k];
  for (Eigen::Index i = 0; i < whole.free.size(); ++i)
    if (whole.free[i] != 0) free_.push_back(i);
  b_ = x_ = Eigen::VectorXd::Zero(whole.free.size());
  if (!cholesky_.analyse(whole.stiffness, whole.free))
    throw InputError("mesh", "there is no memory for a factor of the stiffness");
  const Cholesky::Status status = cholesky_.factorise(whole.stiffness);
  if (status != Cholesky::Status::done)
    throw InputError("mesh", status == Cholesky::Status::out_of_memory
                                 ? "there is no memory for a factor of the stiffness"
                                 : "the stiffness at rest is singular: nothing holds a part of the body, or it is a "
                                   "flat membrane, which resists nothing that moves it out of its plane");
}

void PencilFactor::solve(const double* b, double* x) {
  for (std::size_t k = 0; k < free_.size(); ++k) b_[free_[k]] = b[k];
  cholesky_.solve(b_, x_);
  for (std::size_t k = 0; k < free_.size(); ++k) x[k] = x_[free_[k]];
}

}  // namespace sim
