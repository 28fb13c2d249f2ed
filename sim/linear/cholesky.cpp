#include "sim/linear/cholesky.h"

#include <cblas.h>
#include <cholmod.h>
#include <omp.h>

#include <algorithm>

namespace sim {

Cholesky::Cholesky() : common_(new cholmod_common) {
  openblas_set_num_threads(1);
  cholmod_start(common_);
  common_->print = 0;
  common_->quick_return_if_not_posdef = 1;
  common_->final_ll = 1;  // the L D L' of small matrices would pass over negative pivots
  common_->error_handler = [](int, const char*, int, const char*) {};
}

Cholesky::~Cholesky() {
  free_all();
  cholmod_finish(common_);
  delete common_;
}

void Cholesky::free_all() {
  cholmod_free_sparse(&matrix_, common_);
  cholmod_free_factor(&factor_, common_);
  for (cholmod_dense** d : {&b_, &x_, &work_y_, &work_e_}) cholmod_free_dense(d, common_);
}

// Lower half, by columns: entry (row, column) of the free part <- the place of it in the blocks of A.
bool Cholesky::analyse(const BlockMatrix& A, const Eigen::VectorXd& free) {
  free_all();
  const int D = A.D(), n = A.pattern().rows() * D;
  std::vector<int> number(n, -1);
  dof_.clear();
  for (int i = 0; i < n; ++i)
    if (free[i] != 0) {
      number[i] = static_cast<int>(dof_.size());
      dof_.push_back(i);
    }
  source_.clear();
  std::vector<int> start = {0}, row;
  for (const int i : dof_) {
    const int node = i / D, c = i % D;
    for (int k = A.pattern().start[node]; k < A.pattern().start[node + 1]; ++k)
      for (int r = 0; r < D; ++r) {
        const int other = number[A.pattern().column[k] * D + r];
        if (other < number[i]) continue;
        row.push_back(other);
        source_.push_back((static_cast<std::size_t>(k) * D + c) * D +
                          r);  // A is symmetric: (i, other) stands for (other, i)
      }
    start.push_back(static_cast<int>(row.size()));
  }
  const std::size_t size = dof_.size();
  matrix_ = cholmod_allocate_sparse(size, size, row.size(), 1, 1, -1, CHOLMOD_REAL, common_);
  b_ = cholmod_allocate_dense(size, 1, size, CHOLMOD_REAL, common_);
  if (!matrix_ || !b_) return false;
  std::copy(start.begin(), start.end(), static_cast<int*>(matrix_->p));
  std::copy(row.begin(), row.end(), static_cast<int*>(matrix_->i));
  std::fill_n(static_cast<double*>(matrix_->x), row.size(), 1.0);
  factor_ = cholmod_analyze(matrix_, common_);
  if (!factor_) return false;
  factor_nonzeros_ = static_cast<std::int64_t>(common_->lnz);
  factor_operations_ = common_->fl;
  solves_per_factor_ = common_->fl / (8 * 4 * std::max(common_->lnz, 1.0));
  return true;
}

Cholesky::Status Cholesky::factorise(const BlockMatrix& A) {
  auto* values = static_cast<double*>(matrix_->x);
  for (std::size_t k = 0; k < source_.size(); ++k) values[k] = A.values()[source_[k]];
  // CHOLMOD opens teams of its own, of four threads whatever the machine has: none within this one.
  const int levels = omp_get_max_active_levels();
  omp_set_max_active_levels(0);
  cholmod_factorize(matrix_, factor_, common_);
  omp_set_max_active_levels(levels);
  if (common_->status == CHOLMOD_NOT_POSDEF) return Status::not_positive_definite;
  return common_->status >= CHOLMOD_OK ? Status::done : Status::out_of_memory;
}

void Cholesky::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  auto* in = static_cast<double*>(b_->x);
  for (std::size_t k = 0; k < dof_.size(); ++k) in[k] = b[dof_[k]];
  cholmod_solve2(CHOLMOD_A, factor_, b_, nullptr, &x_, nullptr, &work_y_, &work_e_, common_);
  const auto* out = static_cast<const double*>(x_->x);
  x.setZero();
  for (std::size_t k = 0; k < dof_.size(); ++k) x[dof_[k]] = out[k];
}

}  // namespace sim
