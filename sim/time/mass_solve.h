// a = M^{-1} f on the free components: a division where the mass is lumped, conjugate gradients where it is consistent
// (the diagonal is a good preconditioner there: the condition number does not grow with the mesh [Wathen 1987]).
#pragma once

#include "sim/linear/pcg.h"
#include "sim/solve/model.h"

namespace sim {

class MassSolve {
 public:
  explicit MassSolve(const Model& model);
  // Returns the iterations that were needed; 0 for lumped mass. a is zero where free is.
  int solve(const Eigen::VectorXd& f, const Eigen::VectorXd& free, Eigen::VectorXd& a);

 private:
  const Model& model_;
  bool lumped_ = true;
  Eigen::VectorXd inverse_diagonal_, rhs_;
  PcgScratch scratch_;
};

}  // namespace sim
