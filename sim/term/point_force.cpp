#include "sim/term/point_force.h"

#include <sstream>

#include "sim/term/ramp.h"

namespace sim {

PointLoad::PointLoad(const std::string& body, const PointForce& force, std::vector<int> nodes,
                     std::vector<double> weights, int D)
    : body_(body), force_(force), nodes_(std::move(nodes)), weights_(std::move(weights)), D_(D) {}

TermInfo PointLoad::info() const {
  std::ostringstream what;
  what << "(" << force_.value.x() << ", " << force_.value.y() << ", " << force_.value.z() << ") N at (" << force_.at.x()
       << ", " << force_.at.y() << ", " << force_.at.z() << ") m";
  return {"force " + body_, what.str()};
}

double PointLoad::energy(const Motion& motion, Store&) const {
  Vec3 way = -force_.at;
  for (std::size_t a = 0; a < nodes_.size(); ++a)
    way.head(D_) += weights_[a] * motion.x.segment(static_cast<Eigen::Index>(nodes_[a]) * D_, D_);
  return -risen(motion.t, force_.ramp) * force_.value.head(D_).dot(way.head(D_));
}

void PointLoad::add_forces(const Motion& motion, Store&, Eigen::VectorXd& f) const {
  for (std::size_t a = 0; a < nodes_.size(); ++a)
    f.segment(static_cast<Eigen::Index>(nodes_[a]) * D_, D_) +=
        risen(motion.t, force_.ramp) * weights_[a] * force_.value.head(D_);
}

}  // namespace sim
