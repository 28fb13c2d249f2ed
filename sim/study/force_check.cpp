#include "sim/study/force_check.h"

#include "sim/build/parts.h"
#include "sim/solve/tangent_operator.h"

namespace sim {

namespace {

// U of the elastic terms [J]
class ElasticEnergy {
 public:
  explicit ElasticEnergy(const Model& model) : model_(model), still_(Eigen::VectorXd::Zero(model.dofs())) {
    for (const ElasticPart& part : model.elastic) stores_.push_back(part.term->make_store(1));
  }
  double operator()(const Eigen::VectorXd& x) const {
    double U = 0;
    for (std::size_t k = 0; k < stores_.size(); ++k)
      U += model_.elastic[k].term->energy({x, still_, 0, 0}, *stores_[k]);
    return U;
  }
  void add_forces(const Eigen::VectorXd& x, Eigen::VectorXd& f) const {
    for (std::size_t k = 0; k < stores_.size(); ++k)
      model_.elastic[k].term->add_forces({x, still_, 0, 0}, *stores_[k], f);
  }

 private:
  const Model& model_;
  Eigen::VectorXd still_;
  std::vector<std::unique_ptr<Term::Store>> stores_;
};

}  // namespace

ForceCheck check_forces(const System& system, const State& state, double h) {
  const Model& model = parts_of(system).model;
  const ElasticEnergy energy(model);
  ForceCheck check{Eigen::VectorXd::Zero(model.dofs()), Eigen::VectorXd(model.dofs()), 0, 0};
  energy.add_forces(state.x, check.galerkin);
  Eigen::VectorXd x = state.x;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    x[i] = state.x[i] + h;
    const double above = energy(x);
    x[i] = state.x[i] - h;
    check.ritz[i] = (energy(x) - above) / (2 * h);
    x[i] = state.x[i];
  }
  check.largest = check.galerkin.cwiseAbs().maxCoeff();
  check.difference = (check.galerkin - check.ritz).cwiseAbs().maxCoeff();
  return check;
}

ProductCheck check_product(const System& system, const State& state, const Eigen::VectorXd& dx) {
  const Model& model = parts_of(system).model;
  TangentOperator tangent(model, 1);
  tangent.free().setOnes();
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(model.dofs());
  Eigen::VectorXd f(model.dofs()), Kdx(model.dofs());
  tangent.begin_step({state.x, still, 0, 0});
  tangent.linearise({state.x, still, 0, 0}, 0, Definiteness::none, f);
  BlockMatrix K(*model.pattern, model.D);
  tangent.assemble(K);
  ProductCheck check{Eigen::VectorXd(model.dofs()), Eigen::VectorXd(model.dofs()), 0};
  tangent.multiply(dx, Kdx);
  check.by_elements = -Kdx;
  K.multiply(dx, Kdx, 1);
  check.by_matrix = -Kdx;
  check.difference = (check.by_elements - check.by_matrix).cwiseAbs().maxCoeff();
  return check;
}

}  // namespace sim
