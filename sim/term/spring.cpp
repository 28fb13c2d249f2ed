#include "sim/term/spring.h"

#include <sstream>

namespace sim {

SpringTerm::SpringTerm(const Spring& spring, std::vector<int> nodes, std::vector<double> weights, int D)
    : spring_(spring), nodes_(std::move(nodes)), weights_(std::move(weights)), D_(D) {}

TermInfo SpringTerm::info() const {
  std::ostringstream what;
  what << spring_.stiffness << " N/m to (" << spring_.target.transpose() << ") m";
  return {"spring " + spring_.body, what.str()};
}

Vec3 SpringTerm::point(const Eigen::VectorXd& x) const {
  Vec3 p = Vec3::Zero();
  for (std::size_t a = 0; a < nodes_.size(); ++a)
    p.head(D_) += weights_[a] * x.segment(static_cast<Eigen::Index>(nodes_[a]) * D_, D_);
  return p;
}

double SpringTerm::energy(const Motion& motion, Store&) const {
  return 0.5 * spring_.stiffness * (point(motion.x) - spring_.target).head(D_).squaredNorm();
}

void SpringTerm::add_forces(const Motion& motion, Store&, Eigen::VectorXd& f) const {
  const Vec3 pull = spring_.stiffness * (spring_.target - point(motion.x));
  for (std::size_t a = 0; a < nodes_.size(); ++a)
    f.segment(static_cast<Eigen::Index>(nodes_[a]) * D_, D_) += weights_[a] * pull.head(D_);
}

void SpringTerm::add_product(const Store&, double s, const Eigen::VectorXd& p, Eigen::VectorXd& y) const {
  const Vec3 kp = s * spring_.stiffness * point(p);
  for (std::size_t a = 0; a < nodes_.size(); ++a)
    y.segment(static_cast<Eigen::Index>(nodes_[a]) * D_, D_) += weights_[a] * kp.head(D_);
}

void SpringTerm::add_matrix(const Store&, double s, BlockMatrix& A) const {
  const std::size_t n = nodes_.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b)
      for (int c = 0; c < D_; ++c)
        A.block(slot_[a * n + b])[c * D_ + c] += s * spring_.stiffness * weights_[a] * weights_[b];
}

void SpringTerm::add_diagonal(const Store&, double s, Eigen::VectorXd& d) const {
  for (std::size_t a = 0; a < nodes_.size(); ++a)
    d.segment(static_cast<Eigen::Index>(nodes_[a]) * D_, D_).array() +=
        s * spring_.stiffness * weights_[a] * weights_[a];
}

void SpringTerm::bind(const BlockPattern& pattern) {
  for (const int a : nodes_)
    for (const int b : nodes_) slot_.push_back(pattern.slot(a, b));
}

}  // namespace sim
