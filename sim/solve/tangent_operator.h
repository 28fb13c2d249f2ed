// The matrix of a Newton step, A = c M + K with K = sum over the terms, restricted to the free components; given as a
// product, as a diagonal, or assembled. Which of these is formed is the linear solver's choice.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "sim/solve/model.h"

namespace sim {

// Where A was linearised: all that is needed to make it again.
struct Linearisation {
  Motion begin, at;  // of the step, and within it
  double c;          // 1/(g h)^2, 0 for a static problem
  Definiteness fix;
};

class TangentOperator {
 public:
  TangentOperator(const Model& model, int threads);

  // Terms freeze what they keep for a step.
  void begin_step(const Motion& start);
  bool lags() const;  // some term does
  // Linearises every term at the motion, in the step that has begun; c [1/s^2]. f = -grad U (not restricted).
  void linearise(const Motion& motion, double c, Definiteness fix, Eigen::VectorXd& f);
  // Where that was, while the vectors of the step's beginning live.
  const Linearisation& linearisation() const { return *where_; }
  // Another number after every linearisation.
  std::int64_t revision() const { return revision_; }
  // f = -grad U
  void forces(const Motion& motion, Eigen::VectorXd& f);
  // The part of them that is of barriers, as often as they count.
  void barrier_forces(const Motion& motion, Eigen::VectorXd& f);
  // U, +infinity where a term does not allow the motion
  double energy(const Motion& motion);
  bool limits_moves() const;  // some term does
  double largest_step(const Motion& motion, const Eigen::VectorXd& dx);

  // free[i] = 0: component i is prescribed
  Eigen::VectorXd& free() { return free_; }
  const Eigen::VectorXd& free() const { return free_; }
  int epoch() const { return epoch_; }
  void set_epoch(int epoch) { epoch_ = epoch; }  // changes when the free components do

  // y = A p; p must be zero on prescribed components, y is.
  void multiply(const Eigen::VectorXd& p, Eigen::VectorXd& y) const;
  // d = diagonal of A, 1 on prescribed components.
  void diagonal(Eigen::VectorXd& d) const;
  // A, prescribed components included (the solver leaves them out): the blocks (i, j) with i <= j.
  void assemble_upper(BlockMatrix& A) const;
  // The same, and the others.
  void assemble(BlockMatrix& A) const;

  const Model& model() const { return model_; }
  int threads() const { return threads_; }
  std::span<const std::unique_ptr<Term::Store>> stores() const { return stores_; }

 private:
  double times(std::size_t term, const Motion& motion) const;
  template <class Add>
  void add_forces_of(std::size_t term, const Motion& motion, Eigen::VectorXd& f, const Add& add);

  const Model& model_;
  int threads_;
  std::vector<std::unique_ptr<Term::Store>> stores_;  // one for each term
  Eigen::VectorXd free_;
  int epoch_ = -1;
  std::optional<Motion> begin_;
  std::optional<Linearisation> where_;
  Eigen::VectorXd x_, v_;  // of its motion
  Eigen::VectorXd part_;   // forces of one term
  std::int64_t revision_ = 0;
};

}  // namespace sim
