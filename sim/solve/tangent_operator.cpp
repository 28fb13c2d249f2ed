#include "sim/solve/tangent_operator.h"

#include <algorithm>

namespace sim {

TangentOperator::TangentOperator(const Model& model, int threads)
    : model_(model), threads_(threads), free_(Eigen::VectorXd::Ones(model.dofs())) {
  for (const auto& term : model.terms) stores_.push_back(term->make_store(threads));
}

void TangentOperator::begin_step(const Motion& start) {
  begin_.emplace(start);
  for (std::size_t k = 0; k < stores_.size(); ++k) model_.terms[k]->begin_step(start, *stores_[k]);
}

bool TangentOperator::lags() const {
  return std::any_of(model_.terms.begin(), model_.terms.end(), [](const auto& term) { return term->lags(); });
}

// How often a term counts: once, unless it is a barrier.
double TangentOperator::times(std::size_t term, const Motion& motion) const {
  return model_.terms[term]->limits_moves() ? motion.barriers : 1;
}

// f += the forces that add(term, its store, to) adds to zero, as often as they count
template <class Add>
void TangentOperator::add_forces_of(std::size_t term, const Motion& motion, Eigen::VectorXd& f, const Add& add) {
  const double n = times(term, motion);
  if (n == 1) {
    add(*model_.terms[term], *stores_[term], f);
  } else if (n != 0) {
    part_.setZero(f.size());
    add(*model_.terms[term], *stores_[term], part_);
    f += n * part_;
  }
}

void TangentOperator::linearise(const Motion& motion, double c, Definiteness fix, Eigen::VectorXd& f) {
  x_ = motion.x;
  v_ = motion.v;
  where_.emplace(*begin_, Motion{x_, v_, motion.t, motion.dv_dx, motion.barriers}, c, fix);
  ++revision_;
  f.setZero();
  // An iteration that tries the exact tangent keeps that of barriers as the scene has it: the way in which they curve
  // would lead nodes around what is in their way.
  const Definiteness barrier_fix = fix == Definiteness::none ? model_.solver.definiteness : fix;
  for (std::size_t k = 0; k < stores_.size(); ++k)
    add_forces_of(k, motion, f, [&](const Term& term, Term::Store& store, Eigen::VectorXd& to) {
      term.linearise(motion, term.limits_moves() ? barrier_fix : fix, store, to);
    });
}

void TangentOperator::forces(const Motion& motion, Eigen::VectorXd& f) {
  f.setZero();
  for (std::size_t k = 0; k < stores_.size(); ++k)
    add_forces_of(k, motion, f, [&](const Term& term, Term::Store& store, Eigen::VectorXd& to) {
      term.add_forces(motion, store, to);
    });
}

void TangentOperator::barrier_forces(const Motion& motion, Eigen::VectorXd& f) {
  f.setZero();
  for (std::size_t k = 0; k < stores_.size(); ++k)
    if (model_.terms[k]->limits_moves()) model_.terms[k]->add_forces(motion, *stores_[k], f);
  f *= motion.barriers;
}

double TangentOperator::energy(const Motion& motion) {
  double U = 0;
  for (std::size_t k = 0; k < stores_.size(); ++k)
    if (const double n = times(k, motion); n != 0) U += n * model_.terms[k]->energy(motion, *stores_[k]);
  return U;
}

bool TangentOperator::limits_moves() const {
  return model_.limits_moves();
}

double TangentOperator::largest_step(const Motion& motion, const Eigen::VectorXd& dx) {
  double a = 1;
  for (std::size_t k = 0; k < stores_.size(); ++k)
    a = std::min(a, model_.terms[k]->largest_step(motion, dx, *stores_[k]));
  return a;
}

void TangentOperator::multiply(const Eigen::VectorXd& p, Eigen::VectorXd& y) const {
  y.setZero();
  for (const Mass& mass : model_.masses) mass.add_product(where_->c, p, y, model_.D);
  for (std::size_t k = 0; k < stores_.size(); ++k)
    model_.terms[k]->add_product(*stores_[k], times(k, where_->at), p, y);
  y.array() *= free_.array();
}

void TangentOperator::diagonal(Eigen::VectorXd& d) const {
  d.setZero();
  for (const Mass& mass : model_.masses) mass.add_diagonal(where_->c, d, model_.D);
  for (std::size_t k = 0; k < stores_.size(); ++k) model_.terms[k]->add_diagonal(*stores_[k], times(k, where_->at), d);
  d.array() = d.array() * free_.array() + (1 - free_.array());
}

void TangentOperator::assemble_upper(BlockMatrix& A) const {
  std::vector<NodePair> pairs;
  for (std::size_t k = 0; k < stores_.size(); ++k) model_.terms[k]->add_pairs(*stores_[k], pairs);
  A.set_zero(pairs);
  for (const Mass& mass : model_.masses) mass.add_matrix(where_->c, A);
  for (std::size_t k = 0; k < stores_.size(); ++k) model_.terms[k]->add_matrix(*stores_[k], times(k, where_->at), A);
}

void TangentOperator::assemble(BlockMatrix& A) const {
  assemble_upper(A);
  A.mirror(threads_);
}

}  // namespace sim
