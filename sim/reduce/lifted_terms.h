// Terms of the energy as functions of reduced coordinates: U(c) = U(X + U c), with forces U^T f and stiffness U^T K U.
#pragma once

#include <vector>

#include "sim/reduce/lift.h"
#include "sim/term/term.h"

namespace sim {

class LiftedTerms final : public Term {
 public:
  // D numbers for each node of the lift, whose numbers the terms use; both must outlive this, and the terms are bound
  // to its pattern from now on. Terms that are barriers are not mixed with others.
  LiftedTerms(const Lift& lift, std::vector<Term*> terms, int D);

  TermInfo info() const override;
  Role role() const override { return terms_[0]->role(); }
  std::unique_ptr<Store> make_store(int threads) const override;
  void begin_step(const Motion& start, Store& store) const override;
  bool lags() const override;
  double energy(const Motion& motion, Store& store) const override;
  void add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const override;
  void linearise(const Motion& motion, Definiteness fix, Store& store, Eigen::VectorXd& f) const override;
  void add_product(const Store& store, double s, const Eigen::VectorXd& p, Eigen::VectorXd& y) const override;
  void add_matrix(const Store& store, double s, BlockMatrix& A) const override;
  void add_diagonal(const Store& store, double s, Eigen::VectorXd& d) const override;
  void couple(Coupling& coupling) const override;
  bool limits_moves() const override { return terms_[0]->limits_moves(); }
  double largest_step(const Motion& motion, const Eigen::VectorXd& dx, Store& store) const override;

 private:
  struct Lifted;
  static Lifted& own(Store& store);
  static const Lifted& own(const Store& store);
  Motion lift(const Motion& motion, Lifted& s) const;

  const Lift& lift_;
  std::vector<Term*> terms_;
  int D_;
  BlockPattern pattern_;
};

}  // namespace sim
