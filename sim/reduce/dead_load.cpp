#include "sim/reduce/dead_load.h"

#include "sim/term/ramp.h"

namespace sim {

double DeadLoad::energy(const Motion& motion, Store&) const {
  return -risen(motion.t, ramp_) * force_.dot(motion.x);
}

void DeadLoad::add_forces(const Motion& motion, Store&, Eigen::VectorXd& f) const {
  f += risen(motion.t, ramp_) * force_;
}

}  // namespace sim
