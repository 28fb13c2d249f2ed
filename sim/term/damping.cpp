#include "sim/term/damping.h"

#include <sstream>

namespace sim {

// The tangents of the step's start, one store for each elastic term, and dv/dx of the last linearisation.
struct RayleighDamping::Frozen : Store {
  std::vector<std::unique_ptr<Store>> tangents;
  double dv_dx = 0;
  Eigen::VectorXd force;
};

RayleighDamping::RayleighDamping(const Body& body, const Mass& mass, std::vector<const ElasticTerm*> elastic, int D)
    : body_(body.name), damping_(body.damping), mass_(mass), elastic_(std::move(elastic)), D_(D) {
  if (damping_.beta == 0) elastic_.clear();
}

TermInfo RayleighDamping::info() const {
  std::ostringstream what;
  what << "alpha = " << damping_.alpha << " 1/s, beta = " << damping_.beta << " s";
  return {"damping " + body_, what.str()};
}

std::unique_ptr<Term::Store> RayleighDamping::make_store(int threads) const {
  auto store = std::make_unique<Frozen>();
  store->threads = threads;
  for (const ElasticTerm* term : elastic_) store->tangents.push_back(term->make_store(threads));
  return store;
}

void RayleighDamping::begin_step(const Motion& start, Store& store) const {
  auto& frozen = static_cast<Frozen&>(store);
  frozen.force.resize(start.x.size());
  for (std::size_t k = 0; k < elastic_.size(); ++k)
    elastic_[k]->linearise(start, Definiteness::clamp, *frozen.tangents[k], frozen.force);
}

double RayleighDamping::energy(const Motion& motion, Store& store) const {
  if (motion.dv_dx == 0) return 0;
  auto& frozen = static_cast<Frozen&>(store);
  frozen.force.setZero(motion.x.size());
  add_forces(motion, store, frozen.force);
  return -0.5 * motion.v.dot(frozen.force) / motion.dv_dx;
}

void RayleighDamping::add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const {
  const auto& frozen = static_cast<const Frozen&>(store);
  mass_.add_product(-damping_.alpha, motion.v, f, D_);
  for (std::size_t k = 0; k < elastic_.size(); ++k)
    elastic_[k]->add_product(*frozen.tangents[k], -damping_.beta, motion.v, f);
}

void RayleighDamping::linearise(const Motion& motion, Definiteness, Store& store, Eigen::VectorXd& f) const {
  static_cast<Frozen&>(store).dv_dx = motion.dv_dx;
  add_forces(motion, store, f);
}

void RayleighDamping::add_product(const Store& store, double s, const Eigen::VectorXd& p, Eigen::VectorXd& y) const {
  const auto& frozen = static_cast<const Frozen&>(store);
  mass_.add_product(s * frozen.dv_dx * damping_.alpha, p, y, D_);
  for (std::size_t k = 0; k < elastic_.size(); ++k)
    elastic_[k]->add_product(*frozen.tangents[k], s * frozen.dv_dx * damping_.beta, p, y);
}

void RayleighDamping::add_matrix(const Store& store, double s, BlockMatrix& A) const {
  const auto& frozen = static_cast<const Frozen&>(store);
  mass_.add_matrix(s * frozen.dv_dx * damping_.alpha, A);
  for (std::size_t k = 0; k < elastic_.size(); ++k)
    elastic_[k]->add_matrix(*frozen.tangents[k], s * frozen.dv_dx * damping_.beta, A);
}

void RayleighDamping::add_diagonal(const Store& store, double s, Eigen::VectorXd& d) const {
  const auto& frozen = static_cast<const Frozen&>(store);
  mass_.add_diagonal(s * frozen.dv_dx * damping_.alpha, d, D_);
  for (std::size_t k = 0; k < elastic_.size(); ++k)
    elastic_[k]->add_diagonal(*frozen.tangents[k], s * frozen.dv_dx * damping_.beta, d);
}

}  // namespace sim
