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

void TangentOperator::linearise(const Motion& motion, double c, Definiteness fix, Eigen::VectorXd& f) {
  x_ = motion.x;
  v_ = motion.v;
  where_.emplace(*begin_, Motion{x_, v_, motion.t, motion.dv_dx}, c, fix);
  ++revision_;
  f.setZero();
  for (std::size_t k = 0; k < stores_.size(); ++k) model_.terms[k]->linearise(motion, fix, *stores_[k], f);
}

void TangentOperator::forces(const Motion& motion, Eigen::VectorXd& f) {
  f.setZero();
  for (std::size_t k = 0; k < stores_.size(); ++k) model_.terms[k]->add_forces(motion, *stores_[k], f);
}

double TangentOperator::energy(const Motion& motion) {
  double U = 0;
  for (std::size_t k = 0; k < stores_.size(); ++k) U += model_.terms[k]->energy(motion, *stores_[k]);
  return U;
}

bool TangentOperator::limits_moves() const {
  return std::any_of(model_.terms.begin(), model_.terms.end(), [](const auto& term) { return term->limits_moves(); });
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
  for (std::size_t k = 0; k < stores_.size(); ++k) model_.terms[k]->add_product(*stores_[k], 1, p, y);
  y.array() *= free_.array();
}

void TangentOperator::diagonal(Eigen::VectorXd& d) const {
  d.setZero();
  for (const Mass& mass : model_.masses) mass.add_diagonal(where_->c, d, model_.D);
  for (std::size_t k = 0; k < stores_.size(); ++k) model_.terms[k]->add_diagonal(*stores_[k], 1, d);
  d.array() = d.array() * free_.array() + (1 - free_.array());
}

void TangentOperator::assemble_upper(BlockMatrix& A) const {
  std::vector<NodePair> pairs;
  for (std::size_t k = 0; k < stores_.size(); ++k) model_.terms[k]->add_pairs(*stores_[k], pairs);
  A.set_zero(pairs);
  for (const Mass& mass : model_.masses) mass.add_matrix(where_->c, A);
  for (std::size_t k = 0; k < stores_.size(); ++k) model_.terms[k]->add_matrix(*stores_[k], 1, A);
}

void TangentOperator::assemble(BlockMatrix& A) const {
  assemble_upper(A);
  A.mirror(threads_);
}

}  // namespace sim
