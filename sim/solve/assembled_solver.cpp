#include "sim/solve/assembled_solver.h"

#include <algorithm>

#include "sim/solve/kept_factor.h"

namespace sim {

namespace {

// Below it the matrix in single precision is not taken at its word: what is left is measured without it.
constexpr double exact_below = 1e-3;
constexpr int most_refinements = 8;

std::vector<int> first_nodes(const Model& model) {
  std::vector<int> first;
  for (const BodyRange& range : model.ranges) first.push_back(range.first_node);
  first.push_back(model.body_nodes);
  first.push_back(model.node_count);
  return first;
}

}  // namespace

AssembledSolver::AssembledSolver(const Model& model, bool two_levels)
    : two_levels_(two_levels),
      matrix_(*model.pattern, model.D),
      system_(make_block_system(*model.pattern, model.X, model.D, first_nodes(model))),
      rest_(model.dofs()),
      correction_(model.dofs()) {}

double AssembledSolver::bytes_per_iteration() const {
  const double nodes = matrix_.pattern().rows(), blocks = matrix_.pattern().blocks(), D = matrix_.D();
  return (blocks + nodes) * (4 * D * D + 4) + nodes * (12 * 8 * D + 2 * 4 * D * D + 3 * 4 * D);
}

void AssembledSolver::take(const TangentOperator& A) {
  if (revision_ == A.revision()) return;
  revision_ = A.revision();
  A.assemble_upper(matrix_);
  if (epoch_ != A.epoch()) {
    system_->restrict_to(A.free());
    epoch_ = A.epoch();
    held_.what = 0;
  }
  system_->take(matrix_, A.threads());
}

void AssembledSolver::renew(const TangentOperator& A) {
  held_.what = 0;
  if (system_->make_coarse(A.linearisation().at.x, A.threads())) note(A, Kept::coarse, held_);
}

void AssembledSolver::begin_step(TangentOperator& A, const KeptFactor& kept) {
  if (!two_levels_) return;
  if (static_cast<Kept>(kept.what) != Kept::coarse) {
    held_.what = 0;
    return;
  }
  if (!same(kept, held_)) {
    return_to(kept, A, rest_);
    take(A);
    renew(A);
  }
  if (held_.what == 0) return;
  held_.excess = kept.excess;
  held_.solves = kept.solves;
  held_.fresh = kept.fresh;
}

// Keeps count of what the coarse level's age costs: iterations beyond those of the solve that it was made for.
PcgResult AssembledSolver::conjugate_gradients(int most, const TangentOperator& A, const Eigen::VectorXd& r,
                                               double tolerance, Eigen::VectorXd& dx) {
  PcgResult cg;
  int spent = 0;
  if (held_.what != 0 && static_cast<double>(held_.excess) < system_->iterations_per_coarse()) {
    const int patience = std::min<int>(most, 2 * static_cast<int>(held_.fresh) + 20);
    cg = system_->solve(r, tolerance, patience, A.threads(), dx);
    held_.excess += std::max<std::int64_t>(cg.iterations - held_.fresh, 0);
    ++held_.solves;
    if (cg.converged || !cg.positive_definite || patience == most) return cg;
    spent = cg.iterations;
  }
  if (two_levels_) renew(A);
  if (held_.what == 0) system_->drop_coarse();
  cg = system_->solve(r, tolerance, most, A.threads(), dx);
  held_.fresh = cg.iterations;
  cg.iterations += spent;
  return cg;
}

LinearResult AssembledSolver::solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                                    Eigen::VectorXd& dx) {
  return solve_within(iteration_limit(r.size()), A, r, tolerance, dx);
}

LinearResult AssembledSolver::solve_within(int most, const TangentOperator& A, const Eigen::VectorXd& r,
                                           double tolerance, Eigen::VectorXd& dx) {
  take(A);
  const PcgResult cg = conjugate_gradients(most, A, r, tolerance, dx);
  LinearResult result;
  result.iterations = cg.iterations;
  result.positive_definite = usable(cg);
  result.solved = cg.converged;
  if (cg.converged && tolerance < exact_below) refine(most, A, r, tolerance, dx, result);
  return result;
}

// dx += what solves for the residual that A itself leaves, in double, until that is small enough.
void AssembledSolver::refine(int most, const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                             Eigen::VectorXd& dx, LinearResult& result) {
  const double goal = tolerance * r.norm();
  for (int k = 0; k < most_refinements; ++k) {
    A.multiply(dx, rest_);
    rest_ = r - rest_;
    const double left = rest_.norm();
    if (left <= goal) return;
    const PcgResult cg = system_->solve(rest_, 0.5 * goal / left, most, A.threads(), correction_);
    result.iterations += cg.iterations;
    if (!cg.converged) break;
    dx += correction_;
  }
  result.solved = false;
}

}  // namespace sim
