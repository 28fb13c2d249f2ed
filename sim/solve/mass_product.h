// M u of all nodes, where a vector of its own is no matter.
#pragma once

#include "sim/solve/model.h"

namespace sim {

inline Eigen::VectorXd mass_product(const Model& model, const Eigen::VectorXd& u) {
  Eigen::VectorXd Mu = Eigen::VectorXd::Zero(u.size());
  for (const Mass& mass : model.masses) mass.add_product(1, u, Mu, model.D);
  return Mu;
}

}  // namespace sim
