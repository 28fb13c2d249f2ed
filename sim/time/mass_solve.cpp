#include "sim/time/mass_solve.h"

namespace sim {

MassSolve::MassSolve(const Model& model)
    : model_(model), inverse_diagonal_(Eigen::VectorXd::Zero(model.dofs())), rhs_(model.dofs()) {
  for (const Mass& mass : model.masses) {
    mass.add_diagonal(1, inverse_diagonal_, model.D);
    lumped_ = lumped_ && mass.lumped();
  }
  inverse_diagonal_ = inverse_diagonal_.cwiseInverse();
}

int MassSolve::solve(const Eigen::VectorXd& f, const Eigen::VectorXd& free, Eigen::VectorXd& a) {
  if (lumped_) {
    a = inverse_diagonal_.cwiseProduct(f).cwiseProduct(free);
    return 0;
  }
  constexpr double round_off = 1e-14;
  rhs_ = f.cwiseProduct(free);
  const PcgResult cg = pcg(
      [&](const Eigen::VectorXd& p, Eigen::VectorXd& Mp) {
        Mp.setZero();
        for (const Mass& mass : model_.masses) mass.add_product(1, p, Mp, model_.D);
        Mp.array() *= free.array();
      },
      [&](const Eigen::VectorXd& r, Eigen::VectorXd& z) { z = inverse_diagonal_.cwiseProduct(r); }, rhs_, round_off,
      200, scratch_, a);
  return cg.iterations;
}

}  // namespace sim
