// A reduced system at rest, c = 0.
#pragma once

#include "sim/reduce/reduction.h"

namespace sim {

struct AtRest {
  Eigen::MatrixXd K;  // stiffness on the coordinates
  Eigen::VectorXd f;  // what acts on them at t = 0

  explicit AtRest(const Reduction& reduction);
  // Where forces on the coordinates would move the nodes, were everything linear: D numbers per node [m].
  Eigen::VectorXd displacement(const Reduction& reduction, const Eigen::VectorXd& force) const;
};

}  // namespace sim
