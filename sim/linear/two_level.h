// Conjugate gradients on the matrix in single precision, preconditioned on two levels at once:
//
//   z = D^-1 r + Q C^-1 Q' r,   D: diagonal blocks of A,  Q: rigid motions of aggregates of nodes,  C = Q' A Q
//
// All nodes in contact are one block of D. D^-1 takes care of what differs from node to node, the coarse level of what
// is smooth over an aggregate, so that the number of iterations hardly grows with the mesh. [Nicolaides 1987; Vanek,
// Mandel, Brezina 1996, without smoothing] Vectors are in double precision and in the order of the aggregates; sums are
// taken aggregate by aggregate, so that no bit depends on the number of threads.
#pragma once

#include <memory>
#include <span>

#include "sim/linear/aggregates.h"
#include "sim/linear/block_system.h"
#include "sim/linear/coarse_matrix.h"
#include "sim/linear/coupled_rows.h"

namespace sim {

template <int D>
class TwoLevel final : public BlockSystem {
 public:
  // Positions X at rest, D numbers a node; body k has nodes first_node[k] ... first_node[k+1]-1.
  TwoLevel(const BlockPattern& pattern, const Eigen::VectorXd& X, std::span<const int> first_node);

  void restrict_to(const Eigen::VectorXd& free) override;
  void take(const BlockMatrix& A, int threads) override;
  bool make_coarse(const Eigen::VectorXd& x, int threads) override;
  void drop_coarse() override { coarse_ready_ = false; }
  PcgResult solve(const Eigen::VectorXd& b, double tolerance, int most, int threads, Eigen::VectorXd& x) override;
  double iterations_per_coarse() const override;

 private:
  struct Sums {
    double pAp = 0, rr = 0, rDr = 0;
  };
  void start(const Eigen::VectorXd& b, int aggregate);
  void residual_sums(int aggregate);
  void descend(int aggregate, double step);
  void direct(int aggregate, double beta);
  double coarse_solve();
  void multiply(int aggregate);

  Aggregates aggregates_;
  FloatMatrix<D> A_;
  RigidModes<D> modes_;
  CoarseMatrix<D> C_;
  CoupledRows<D> coupled_;
  bool coarse_ready_ = false;
  Eigen::VectorXd free_;  // in the order of the aggregates, as are x, r, A p and p
  LargeArray<double> numbers_;
  Eigen::Map<Eigen::VectorXd> x_, r_, Ap_, p_;  // in numbers_, one after the other
  Eigen::VectorXd coarse_r_, coarse_y_;
  std::vector<Sums> sums_;  // of each aggregate
};

}  // namespace sim
