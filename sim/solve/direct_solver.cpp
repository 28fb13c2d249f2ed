#include "sim/solve/direct_solver.h"

#include <algorithm>
#include <utility>

#include "sim/solve/kept_factor.h"

namespace sim {

namespace {

// More iterations than this in one solve and a new factor is made at once.
constexpr int most_iterations = 60;

}  // namespace

DirectSolver::DirectSolver(const Model& model) : model_(model) {}

void DirectSolver::assemble(const TangentOperator& A) {
  if (!matrix_) matrix_.emplace(*model_.pattern, model_.D);
  if (revision_ == A.revision()) return;
  revision_ = A.revision();
  A.assemble(*matrix_);
}

Cholesky::Status DirectSolver::factorise(const TangentOperator& A) {
  if (!cholesky_) cholesky_.emplace();
  if (epoch_ != A.epoch()) {
    if (!cholesky_->analyse(*matrix_, A.free())) return Cholesky::Status::out_of_memory;
    epoch_ = A.epoch();
  }
  return cholesky_->factorise(*matrix_);
}

void DirectSolver::give_up_factor() {
  matrix_.reset();
  cholesky_.reset();
  held_ = {};
  fallback_.emplace(model_);
  to_be_said_ = true;
}

void DirectSolver::begin_step(TangentOperator& A, const KeptFactor& kept) {
  if (fallback_) return;
  if (static_cast<Kept>(kept.what) != Kept::factor) {
    held_.what = 0;
    return;
  }
  const bool held = same(kept, held_);
  held_ = kept;
  if (held) return;
  return_to(kept, A, scratch_.r);
  assemble(A);
  if (factorise(A) == Cholesky::Status::out_of_memory) give_up_factor();
}

bool DirectSolver::worn(const TangentOperator& A) const {
  return held_.what == 0 || epoch_ != A.epoch() || static_cast<double>(held_.excess) >= cholesky_->solves_per_factor();
}

// The factor, and an iteration for every solve with what its age added, shared by the solves that it served. A solve
// reads the factor twice, an iteration the matrix as well.
double DirectSolver::bytes_per_solve() const {
  const double solve = 2.0 * 8 * static_cast<double>(cholesky_->factor_nonzeros());
  const double iteration = solve + 8.0 * static_cast<double>(matrix_->values().size());
  const double solves = static_cast<double>(held_.solves), excess = static_cast<double>(held_.excess);
  return (cholesky_->solves_per_factor() * solve + (solves + excess) * iteration) / std::max(solves, 1.0);
}

LinearResult DirectSolver::solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                                 Eigen::VectorXd& dx) {
  LinearResult result;
  if (fallback_) {
    result = fallback_->solve(A, r, tolerance, dx);
    result.no_factor = std::exchange(to_be_said_, false);
    return result;
  }
  assemble(A);
  if (!worn(A)) {
    const PcgResult cg = pcg(
        [&](const auto& p, auto& Ap) {
          matrix_->multiply(p, Ap, A.threads());
          Ap.array() *= A.free().array();
        },
        [&](const auto& residual, auto& z) { cholesky_->solve(residual, z); }, r, tolerance, most_iterations, scratch_,
        dx);
    result.iterations = cg.iterations;
    held_.excess += std::max(cg.iterations - 1, 0);
    ++held_.solves;
    if (cg.converged) return result;
  }
  held_.what = 0;
  const Cholesky::Status status = factorise(A);
  if (status == Cholesky::Status::out_of_memory) {
    give_up_factor();
    return solve(A, r, tolerance, dx);
  }
  ++result.factorisations;
  result.positive_definite = status == Cholesky::Status::done;
  if (!result.positive_definite) return result;
  note(A, Kept::factor, held_);
  held_.solves = 1;
  cholesky_->solve(r, dx);
  ++result.iterations;
  return result;
}

}  // namespace sim
