#include "sim/term/gravity.h"

#include <sstream>

namespace sim {

Gravity::Gravity(const Vec3& g, const std::vector<Mass>& masses, const Eigen::VectorXd& X, int D)
    : weight_(Eigen::VectorXd::Zero(X.size())), X_(X), g_(g) {
  for (const Mass& mass : masses)
    for (int i = 0; i < mass.nodal().size(); ++i)
      weight_.segment(static_cast<Eigen::Index>(mass.first_node() + i) * D, D) = mass.nodal()[i] * g.head(D);
}

TermInfo Gravity::info() const {
  std::ostringstream what;
  what << "g = (" << g_.x() << ", " << g_.y() << ", " << g_.z() << ") m/s^2";
  return {"gravity", what.str()};
}

double Gravity::energy(const Motion& motion, Store&) const {
  return -weight_.dot(motion.x - X_);
}

void Gravity::add_forces(const Motion&, Store&, Eigen::VectorXd& f) const {
  f += weight_;
}

}  // namespace sim
