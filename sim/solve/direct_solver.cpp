#include "sim/solve/direct_solver.h"

#include <utility>

namespace sim {

namespace {

// More iterations than this in one solve and a new factor is made at once.
constexpr int most_iterations = 60;

bool same_factor(const KeptFactor& a, const KeptFactor& b) {
  return a.valid == b.valid && a.definiteness == b.definiteness && a.t_begin == b.t_begin && a.t == b.t &&
         a.dv_dx == b.dv_dx && a.c == b.c && a.x_begin == b.x_begin && a.v_begin == b.v_begin && a.x == b.x &&
         a.v == b.v;
}

}  // namespace

DirectSolver::DirectSolver(const Model& model) : model_(model) {
  matrix_.emplace(*model.pattern, model.D);
  cholesky_.emplace();
}

Cholesky::Status DirectSolver::factorise(const TangentOperator& A) {
  if (epoch_ != A.epoch()) {
    if (!cholesky_->analyse(*matrix_, A.free())) return Cholesky::Status::out_of_memory;
    epoch_ = A.epoch();
  }
  return cholesky_->factorise(*matrix_);
}

void DirectSolver::remember(const TangentOperator& A) {
  const Linearisation& where = A.linearisation();
  held_.valid = 1;
  held_.excess = 0;
  held_.definiteness = static_cast<int>(where.fix);
  held_.t_begin = where.begin.t;
  held_.t = where.at.t;
  held_.dv_dx = where.at.dv_dx;
  held_.c = where.c;
  held_.x_begin = where.begin.x;
  held_.v_begin = where.begin.v;
  held_.x = where.at.x;
  held_.v = where.at.v;
}

void DirectSolver::give_up_factor() {
  matrix_.reset();
  cholesky_.reset();
  held_ = {};
  fallback_.emplace(model_, /*with_matrix=*/false);
  to_be_said_ = true;
}

void DirectSolver::begin_step(TangentOperator& A, const KeptFactor& kept) {
  if (fallback_) return;
  held_.valid = held_.valid && kept.valid;
  if (!kept.valid) return;
  if (same_factor(kept, held_)) {
    held_.excess = kept.excess;
    return;
  }
  held_ = kept;
  A.begin_step({held_.x_begin, held_.v_begin, held_.t_begin, 0});
  scratch_.resize(model_.dofs());
  A.linearise({held_.x, held_.v, held_.t, held_.dv_dx}, held_.c, static_cast<Definiteness>(held_.definiteness),
              scratch_.r);
  A.assemble(*matrix_);
  if (factorise(A) == Cholesky::Status::out_of_memory) give_up_factor();
}

LinearResult DirectSolver::solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                                 Eigen::VectorXd& dx) {
  LinearResult result;
  if (fallback_) {
    result = fallback_->solve(A, r, tolerance, dx);
    result.no_factor = std::exchange(to_be_said_, false);
    return result;
  }
  A.assemble(*matrix_);
  if (held_.valid && epoch_ == A.epoch() && held_.excess < cholesky_->solves_per_factor()) {
    const PcgResult cg = pcg(
        [&](const auto& p, auto& Ap) {
          matrix_->multiply(p, Ap, A.threads());
          Ap.array() *= A.free().array();
        },
        [&](const auto& residual, auto& z) { cholesky_->solve(residual, z); }, r, tolerance, most_iterations, scratch_,
        dx);
    result.iterations = cg.iterations;
    held_.excess += std::max(cg.iterations - 1, 0);
    if (cg.converged) return result;
  }
  held_.valid = 0;
  const Cholesky::Status status = factorise(A);
  if (status == Cholesky::Status::out_of_memory) {
    give_up_factor();
    return solve(A, r, tolerance, dx);
  }
  ++result.factorisations;
  result.positive_definite = status == Cholesky::Status::done;
  if (!result.positive_definite) return result;
  remember(A);
  cholesky_->solve(r, dx);
  ++result.iterations;
  return result;
}

}  // namespace sim
