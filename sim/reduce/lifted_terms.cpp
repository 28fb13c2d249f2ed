#include "sim/reduce/lifted_terms.h"

#include <algorithm>
#include <numeric>

namespace sim {

// The stores of the terms, and what stands where coordinates are lifted to; K as a whole and R = U^T K U.
struct LiftedTerms::Lifted : Store {
  std::vector<std::unique_ptr<Store>> stores;
  Eigen::VectorXd x, v, f, dx;
  std::vector<NodePair> pairs;
  std::unique_ptr<BlockMatrix> K;
  Lift::Scratch scratch;
  Eigen::MatrixXd R;  // its upper half
};

LiftedTerms::Lifted& LiftedTerms::own(Store& store) {
  return static_cast<Lifted&>(store);
}
const LiftedTerms::Lifted& LiftedTerms::own(const Store& store) {
  return static_cast<const Lifted&>(store);
}

LiftedTerms::LiftedTerms(const Lift& lift, std::vector<Term*> terms, int D)
    : lift_(lift), terms_(std::move(terms)), D_(D) {
  Coupling coupling(static_cast<int>(lift_.dofs()) / D_);
  for (const Term* term : terms_) term->couple(coupling);
  pattern_ = coupling.pattern();
  for (Term* term : terms_) term->bind(pattern_);
}

TermInfo LiftedTerms::info() const {
  std::string names;
  for (const Term* term : terms_) names += (names.empty() ? "" : ", ") + term->info().name;
  return {"reduced", names};
}

std::unique_ptr<Term::Store> LiftedTerms::make_store(int threads) const {
  auto store = std::make_unique<Lifted>();
  store->threads = threads;
  for (const Term* term : terms_) store->stores.push_back(term->make_store(threads));
  for (Eigen::VectorXd* vector : {&store->x, &store->v, &store->f, &store->dx}) vector->resize(lift_.dofs());
  return store;
}

// The motion of the nodes, in the store.
Motion LiftedTerms::lift(const Motion& motion, Lifted& s) const {
  lift_.place(motion.x, s.x);
  lift_.move(motion.v, s.v);
  return {s.x, s.v, motion.t, motion.dv_dx, motion.barriers};
}

void LiftedTerms::begin_step(const Motion& start, Store& store) const {
  Lifted& s = own(store);
  const Motion lifted = lift(start, s);
  for (std::size_t k = 0; k < terms_.size(); ++k) terms_[k]->begin_step(lifted, *s.stores[k]);
}

bool LiftedTerms::lags() const {
  return std::any_of(terms_.begin(), terms_.end(), [](const Term* term) { return term->lags(); });
}

double LiftedTerms::energy(const Motion& motion, Store& store) const {
  Lifted& s = own(store);
  const Motion lifted = lift(motion, s);
  double U = 0;
  for (std::size_t k = 0; k < terms_.size(); ++k) U += terms_[k]->energy(lifted, *s.stores[k]);
  return U;
}

void LiftedTerms::add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const {
  Lifted& s = own(store);
  const Motion lifted = lift(motion, s);
  s.f.setZero();
  for (std::size_t k = 0; k < terms_.size(); ++k) terms_[k]->add_forces(lifted, *s.stores[k], s.f);
  lift_.gather(s.f, f);
}

void LiftedTerms::linearise(const Motion& motion, Definiteness fix, Store& store, Eigen::VectorXd& f) const {
  Lifted& s = own(store);
  const Motion lifted = lift(motion, s);
  s.f.setZero();
  s.pairs.clear();
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    terms_[k]->linearise(lifted, fix, *s.stores[k], s.f);
    terms_[k]->add_pairs(*s.stores[k], s.pairs);
  }
  lift_.gather(s.f, f);
  if (!s.K) s.K = std::make_unique<BlockMatrix>(pattern_, D_);
  s.K->set_zero(s.pairs);
  for (std::size_t k = 0; k < terms_.size(); ++k) terms_[k]->add_matrix(*s.stores[k], 1, *s.K);
  s.K->mirror(s.threads);
  lift_.reduce(*s.K, s.threads, s.scratch, s.R);
}

void LiftedTerms::add_product(const Store& store, double scale, const Eigen::VectorXd& p, Eigen::VectorXd& y) const {
  y.noalias() += scale * (own(store).R.selfadjointView<Eigen::Upper>() * p);
}

void LiftedTerms::add_matrix(const Store& store, double scale, BlockMatrix& A) const {
  const Eigen::MatrixXd& R = own(store).R;
  for (Eigen::Index i = 0; i < R.rows(); ++i)
    for (Eigen::Index j = i; j < R.cols(); ++j) *A.block(static_cast<int>(i * R.cols() + j)) += scale * R(i, j);
}

void LiftedTerms::add_diagonal(const Store& store, double scale, Eigen::VectorXd& d) const {
  d += scale * own(store).R.diagonal();
}

void LiftedTerms::couple(Coupling& coupling) const {
  std::vector<int> all(static_cast<std::size_t>(lift_.coordinates()));
  std::iota(all.begin(), all.end(), 0);
  coupling.add(all);
}

double LiftedTerms::largest_step(const Motion& motion, const Eigen::VectorXd& dx, Store& store) const {
  if (!limits_moves()) return 1;
  Lifted& s = own(store);
  const Motion lifted = lift(motion, s);
  lift_.move(dx, s.dx);
  double a = 1;
  for (std::size_t k = 0; k < terms_.size(); ++k) a = std::min(a, terms_[k]->largest_step(lifted, s.dx, *s.stores[k]));
  return a;
}

}  // namespace sim
