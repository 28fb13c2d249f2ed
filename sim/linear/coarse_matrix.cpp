#include "sim/linear/coarse_matrix.h"

#include <algorithm>

namespace sim {

namespace {

std::vector<int> aggregate_of_rows(const Aggregates& aggregates) {
  std::vector<int> of(aggregates.order.size());
  for (int a = 0; a < aggregates.count(); ++a)
    std::fill(of.begin() + aggregates.start[a], of.begin() + aggregates.start[a + 1], a);
  return of;
}

// Aggregates are coupled where rows of theirs are.
template <int D>
BlockPattern coarse_pattern(const FloatMatrix<D>& A, const Aggregates& aggregates, const std::vector<int>& of) {
  BlockPattern pattern;
  pattern.start.push_back(0);
  std::vector<int> met;
  for (int a = 0; a < aggregates.count(); ++a) {
    met.clear();
    for (int i = aggregates.start[a]; i < aggregates.start[a + 1]; ++i)
      for (int k = A.begin(i); k < A.end(i); ++k)
        if (met.empty() || met.back() != of[A.column(k)]) met.push_back(of[A.column(k)]);
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    pattern.column.insert(pattern.column.end(), met.begin(), met.end());
    pattern.start.push_back(static_cast<int>(pattern.column.size()));
  }
  return pattern;
}

}  // namespace

template <int D>
CoarseMatrix<D>::CoarseMatrix(const FloatMatrix<D>& A, const Aggregates& aggregates)
    : aggregates_(aggregates),
      aggregate_(aggregate_of_rows(aggregates)),
      pattern_(coarse_pattern(A, aggregates, aggregate_)),
      C_(pattern_, RigidModes<D>::count) {}

// Sets C to zero, with a place for every two aggregates that A couples. Its factor is analysed anew only where blocks
// outside of A's pattern couple others than before.
template <int D>
bool CoarseMatrix<D>::analyse(const FloatMatrix<D>& A) {
  met_.clear();
  for (const auto& block : A.outside()) {
    const int a = aggregate_[block.row], b = aggregate_[block.column];
    if (a < b) met_.push_back({a, b});
  }
  C_.set_zero(met_);
  if (is_analysed_ && analysed_ == C_.outside()) return true;
  is_analysed_ = cholesky_.analyse(C_, Eigen::VectorXd::Ones(size()));
  analysed_ = C_.outside();
  return is_analysed_;
}

template <int D>
bool CoarseMatrix<D>::make(const FloatMatrix<D>& A, const RigidModes<D>& modes, int threads) {
  if (!analyse(A)) return false;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (int a = 0; a < pattern_.rows(); ++a) make_row(a, A, modes);
  return cholesky_.factorise(C_) == Cholesky::Status::done;
}

// C_ab = T_a' (sum_{i in a} B_i' sum_{j in b} A_ij B_j) T_b for b >= a. The inner sum over j is that of A_ij B_j for
// the columns j of row i that lie in b, which follow each other.
template <int D>
void CoarseMatrix<D>::make_row(int a, const FloatMatrix<D>& A, const RigidModes<D>& modes) {
  constexpr int n = RigidModes<D>::count;
  using Square = Eigen::Matrix<double, n, n, Eigen::RowMajor>;
  std::size_t out = A.first_outside(aggregates_.start[a]);
  for (int i = aggregates_.start[a]; i < aggregates_.start[a + 1]; ++i) {
    const typename RigidModes<D>::Columns B = modes.motion(i);
    for (int k = A.begin(i); k < A.end(i);) {
      const int b = aggregate_[A.column(k)];
      typename RigidModes<D>::Columns AB = RigidModes<D>::Columns::Zero();
      for (; k < A.end(i) && aggregate_[A.column(k)] == b; ++k)
        AB.noalias() += A.block(k).template cast<double>().lazyProduct(modes.motion(A.column(k)));
      if (b < a) continue;
      Eigen::Map<Square>(C_.block(pattern_.slot(a, b))).noalias() += B.transpose().lazyProduct(AB);
    }
    for (; out < A.outside().size() && A.outside()[out].row == i; ++out) {
      const auto& block = A.outside()[out];
      if (const int b = aggregate_[block.column]; b >= a)
        Eigen::Map<Square>(C_.find(a, b)) += B.transpose() * block.block * modes.motion(block.column);
    }
  }
  const auto turn = [&](int b, double* values) {
    Eigen::Map<Square> C(values);
    C = (modes.T(a).transpose() * Square(C) * modes.T(b)).eval();
  };
  for (int k = pattern_.start[a]; k < pattern_.start[a + 1]; ++k)
    if (pattern_.column[k] >= a) turn(pattern_.column[k], C_.block(k));
  const auto& pairs = C_.outside();
  for (auto pair = std::lower_bound(pairs.begin(), pairs.end(), NodePair{a, 0}); pair != pairs.end() && pair->i == a;
       ++pair)
    turn(pair->j, C_.find(a, pair->j));
  double* own = C_.block(pattern_.slot(a, a));
  for (int c = 0; c < n; ++c)
    if (modes.left_out(a, c)) own[c * n + c] = 1;
}

template class CoarseMatrix<2>;
template class CoarseMatrix<3>;

}  // namespace sim
