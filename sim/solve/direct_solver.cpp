#include "sim/solve/direct_solver.h"

#include <new>

namespace sim {

namespace {

// More iterations than this in one solve and a new factor is made at once.
constexpr int most_iterations = 60;

void remember(const Linearisation& where, KeptFactor& kept) {
  kept.valid = 1;
  kept.excess = 0;
  kept.definiteness = static_cast<int>(where.fix);
  kept.t_begin = where.begin.t;
  kept.t = where.at.t;
  kept.dv_dx = where.at.dv_dx;
  kept.mass = where.mass;
  kept.x_begin = where.begin.x;
  kept.v_begin = where.begin.v;
  kept.x = where.at.x;
  kept.v = where.at.v;
}

bool same_factor(const KeptFactor& a, const KeptFactor& b) {
  return a.valid == b.valid && a.definiteness == b.definiteness && a.t_begin == b.t_begin && a.t == b.t &&
         a.dv_dx == b.dv_dx && a.mass == b.mass && a.x_begin == b.x_begin && a.v_begin == b.v_begin && a.x == b.x &&
         a.v == b.v;
}

}  // namespace

DirectSolver::DirectSolver(const Model& model) : matrix_(*model.pattern, model.D) {}

bool DirectSolver::factorise(const TangentOperator& A) {
  if (epoch_ != A.epoch()) {
    if (!cholesky_.analyse(matrix_, A.free())) throw std::bad_alloc();
    epoch_ = A.epoch();
  }
  const Cholesky::Status status = cholesky_.factorise(matrix_);
  if (status == Cholesky::Status::out_of_memory) throw std::bad_alloc();
  return status == Cholesky::Status::done;
}

LinearResult DirectSolver::solve(const TangentOperator& A, const Linearisation& where, const Eigen::VectorXd& r,
                                 double tolerance, KeptFactor& kept, Eigen::VectorXd& dx) {
  LinearResult result;
  A.assemble(matrix_);
  if (kept.valid && epoch_ == A.epoch() && kept.excess < cholesky_.solves_per_factor()) {
    const PcgResult cg = pcg(
        [&](const auto& p, auto& Ap) {
          matrix_.multiply(p, Ap, A.threads());
          Ap.array() *= A.free().array();
        },
        [&](const auto& residual, auto& z) { cholesky_.solve(residual, z); }, r, tolerance, most_iterations, scratch_,
        dx);
    result.iterations = cg.iterations;
    kept.excess += std::max(cg.iterations - 1, 0);
    if (cg.converged) return result;
  }
  kept.valid = 0;
  ++result.factorisations;
  result.positive_definite = factorise(A);
  if (!result.positive_definite) return result;
  remember(where, kept);
  held_ = kept;
  cholesky_.solve(r, dx);
  ++result.iterations;
  return result;
}

bool DirectSolver::lost(const KeptFactor& kept) const {
  return kept.valid && !same_factor(kept, held_);
}

void DirectSolver::restore(const TangentOperator& A, const KeptFactor& kept) {
  A.assemble(matrix_);
  factorise(A);
  held_ = kept;
}

}  // namespace sim
