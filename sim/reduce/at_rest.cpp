#include "sim/reduce/at_rest.h"

#include <Eigen/Cholesky>

#include "sim/solve/tangent_operator.h"

namespace sim {

AtRest::AtRest(const Reduction& reduction) {
  const Model& model = reduction.model;
  const Eigen::Index r = model.dofs();
  K.resize(r, r);
  f.resize(r);
  TangentOperator tangent(model, 1);
  tangent.free().setOnes();
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(r);
  Eigen::VectorXd p(r), Kp(r);
  tangent.begin_step({still, still, 0, 0});
  tangent.linearise({still, still, 0, 0}, 0, Definiteness::clamp, f);
  for (Eigen::Index k = 0; k < r; ++k) {
    p = Eigen::VectorXd::Unit(r, k);
    tangent.multiply(p, Kp);
    K.col(k) = Kp;
  }
}

Eigen::VectorXd AtRest::displacement(const Reduction& reduction, const Eigen::VectorXd& force) const {
  const Eigen::VectorXd c = K.ldlt().solve(force);
  Eigen::VectorXd u;
  reduction.lift->move(c, u);
  return u;
}

}  // namespace sim
