// CHOLMOD's Cholesky factor of the free part of a BlockMatrix: analysed once for each set of free components, values
// refilled in place. OpenBLAS runs on one thread, as its bits depend on how many it has.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/math/block_matrix.h"

struct cholmod_common_struct;
struct cholmod_sparse_struct;
struct cholmod_factor_struct;
struct cholmod_dense_struct;

namespace sim {

class Cholesky {
 public:
  Cholesky();
  ~Cholesky();
  Cholesky(const Cholesky&) = delete;
  Cholesky& operator=(const Cholesky&) = delete;

  // The pattern of A without the components where free is 0. False: no memory for it.
  bool analyse(const BlockMatrix& A, const Eigen::VectorXd& free);
  enum class Status { done, not_positive_definite, out_of_memory };
  Status factorise(const BlockMatrix& A);
  // x = A^{-1} b on the free components, 0 on the others; after a factorise that was done.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  // Cost of the factor, in solves: floating-point operations of the one over those of the other, solves being bound by
  // memory (a factor 8 on common machines). Follows from the pattern alone.
  double solves_per_factor() const { return solves_per_factor_; }
  std::int64_t factor_nonzeros() const { return factor_nonzeros_; }
  double factor_operations() const { return factor_operations_; }

 private:
  void free_all();
  cholmod_common_struct* common_;
  cholmod_sparse_struct* matrix_ = nullptr;
  cholmod_factor_struct* factor_ = nullptr;
  cholmod_dense_struct* b_ = nullptr;
  cholmod_dense_struct* x_ = nullptr;
  cholmod_dense_struct* work_y_ = nullptr;
  cholmod_dense_struct* work_e_ = nullptr;
  std::vector<std::size_t> source_;  // of each entry of the matrix, in the values of A
  std::vector<int> dof_;             // of each row
  double solves_per_factor_ = 0, factor_operations_ = 0;
  std::int64_t factor_nonzeros_ = 0;
};

}  // namespace sim
