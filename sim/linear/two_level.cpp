#include "sim/linear/two_level.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

// Nodes in an aggregate. Few: fewer iterations; many: a coarse level that takes less time. The coarse level is solved
// by one thread, so that its size is to grow more slowly than the mesh.
int aggregate_size(int nodes) {
  return std::clamp(nodes / 500, 64, 256);
}

}  // namespace

template <int D>
TwoLevel<D>::TwoLevel(const BlockPattern& pattern, const Eigen::VectorXd& X, std::span<const int> first_node)
    : aggregates_(bisect(X, D, first_node, aggregate_size(pattern.rows()))),
      A_(pattern, aggregates_.order),
      modes_(aggregates_),
      C_(A_, aggregates_),
      free_(Eigen::VectorXd::Ones(X.size())),
      numbers_(4 * X.size() + 1),
      x_(numbers_.data(), X.size()),
      r_(x_.data() + X.size(), X.size()),
      Ap_(r_.data() + X.size(), X.size()),
      p_(Ap_.data() + X.size(), X.size() + 1),
      coarse_r_(C_.size()),
      coarse_y_(C_.size()),
      sums_(aggregates_.count()) {}

template <int D>
void TwoLevel<D>::restrict_to(const Eigen::VectorXd& free) {
  for (int k = 0; k < A_.rows(); ++k)
    free_.segment<D>(static_cast<Eigen::Index>(k) * D) =
        free.segment<D>(static_cast<Eigen::Index>(aggregates_.order[k]) * D);
  A_.restrict_to(free_);
  coarse_ready_ = false;
}

template <int D>
void TwoLevel<D>::take(const BlockMatrix& A, int threads) {
  A_.take(A, threads);
  coupled_.make(A_, free_);
}

template <int D>
bool TwoLevel<D>::make_coarse(const Eigen::VectorXd& x, int threads) {
  modes_.place(x, free_, threads);
  coarse_ready_ = C_.make(A_, modes_, threads);
  return coarse_ready_;
}

// Making C and placing the modes take about as long as two iterations (0.8 % of a step of 12 cells, where the products
// of 56 iterations take 28 %); a factor's operations run some four times as fast as those of a product, which waits for
// memory.
template <int D>
double TwoLevel<D>::iterations_per_coarse() const {
  return 2 + C_.factor_operations() / (4.0 * 2 * D * D * A_.end(A_.rows() - 1));
}

// x = 0, r = b, p = 0, whatever a solve before has left there: numbers that are not finite too.
template <int D>
void TwoLevel<D>::start(const Eigen::VectorXd& b, int a) {
  for (int k = aggregates_.start[a]; k < aggregates_.start[a + 1]; ++k) {
    const Eigen::Index at = static_cast<Eigen::Index>(k) * D;
    r_.segment<D>(at) = A_.scale() * b.segment<D>(static_cast<Eigen::Index>(aggregates_.order[k]) * D);
    x_.segment<D>(at).setZero();
    p_.segment<D>(at).setZero();
  }
  residual_sums(a);
}

// What the next direction needs to know of an aggregate's r: r . r, r . D^-1 r but for rows in contact, Q' r.
template <int D>
void TwoLevel<D>::residual_sums(int a) {
  double rr = 0, rDr = 0;
  for (int k = aggregates_.start[a]; k < aggregates_.start[a + 1]; ++k) {
    const auto r = r_.segment<D>(static_cast<Eigen::Index>(k) * D);
    rr += r.squaredNorm();
    if (coupled_.has(k)) continue;
    rDr += r.dot(A_.inverse(k).template cast<double>() * r);
  }
  sums_[a].rr = rr;
  sums_[a].rDr = rDr;
  if (coarse_ready_)
    coarse_r_.segment<RigidModes<D>::count>(static_cast<Eigen::Index>(a) * RigidModes<D>::count) =
        modes_.restricted(a, r_.data());
}

// x += step p, r -= step A p
template <int D>
void TwoLevel<D>::descend(int a, double step) {
  const Eigen::Index first = static_cast<Eigen::Index>(aggregates_.start[a]) * D,
                     size = static_cast<Eigen::Index>(aggregates_.start[a + 1]) * D - first;
  x_.segment(first, size) += step * p_.segment(first, size);
  r_.segment(first, size) -= step * Ap_.segment(first, size);
  residual_sums(a);
}

// p = D^-1 r + Q y + beta p
template <int D>
void TwoLevel<D>::direct(int a, double beta) {
  constexpr int modes = RigidModes<D>::count;
  typename RigidModes<D>::Vector z = RigidModes<D>::Vector::Zero();
  if (coarse_ready_) z = modes_.amplitudes(a, coarse_y_.data() + static_cast<Eigen::Index>(a) * modes);
  for (int k = aggregates_.start[a]; k < aggregates_.start[a + 1]; ++k) {
    const Eigen::Index at = static_cast<Eigen::Index>(k) * D;
    p_.segment<D>(at) = free_.segment<D>(at).cwiseProduct(modes_.at(k, z)) + beta * p_.segment<D>(at);
    if (coupled_.has(k))
      p_.segment<D>(at) += coupled_.z(k);
    else
      p_.segment<D>(at) += A_.inverse(k).template cast<double>() * r_.segment<D>(at);
  }
}

template <int D>
void TwoLevel<D>::multiply(int a) {
  sums_[a].pAp = A_.multiply(aggregates_.start[a], aggregates_.start[a + 1], p_.data(), Ap_.data());
}

// y = C^-1 Q' r; returns r . Q y.
template <int D>
double TwoLevel<D>::coarse_solve() {
  if (!coarse_ready_) return 0;
  C_.solve(coarse_r_, coarse_y_);
  return coarse_r_.dot(coarse_y_);
}

template <int D>
PcgResult TwoLevel<D>::solve(const Eigen::VectorXd& b, double tolerance, int most, int threads, Eigen::VectorXd& x) {
  PcgResult result;
  const int count = aggregates_.count();
  const auto sum = [&](double Sums::*part) {
    double total = 0;
    for (const Sums& own : sums_) total += own.*part;
    return total;
  };
  double goal = 0, beta = 0, step = 0, rz = 0;
  bool done = false, first = true;
#pragma omp parallel num_threads(threads)
  {
#pragma omp for schedule(static)
    for (int a = 0; a < count; ++a) start(b, a);
    for (;;) {
#pragma omp single
      {
        const double rr = sum(&Sums::rr);
        if (first) goal = tolerance * tolerance * rr;
        result.converged = rr <= goal;
        done = result.converged || result.iterations == most || !std::isfinite(rr);
        if (!done) {
          const double rz_new = sum(&Sums::rDr) + coupled_.solve(r_) + coarse_solve();
          beta = first ? 0 : rz_new / rz;
          rz = rz_new;
          first = false;
          ++result.iterations;
        }
      }
      if (done) break;
#pragma omp for schedule(static)
      for (int a = 0; a < count; ++a) direct(a, beta);
#pragma omp for schedule(static)
      for (int a = 0; a < count; ++a) multiply(a);
#pragma omp single
      {
        const double pAp = sum(&Sums::pAp);
        result.positive_definite = pAp > 0;
        step = rz / pAp;
      }
      if (!result.positive_definite) break;
#pragma omp for schedule(static)
      for (int a = 0; a < count; ++a) descend(a, step);
    }
#pragma omp for schedule(static)
    for (int k = 0; k < A_.rows(); ++k)
      x.segment<D>(static_cast<Eigen::Index>(aggregates_.order[k]) * D) =
          x_.segment<D>(static_cast<Eigen::Index>(k) * D);
  }
  return result;
}

std::unique_ptr<BlockSystem> make_block_system(const BlockPattern& pattern, const Eigen::VectorXd& X, int D,
                                               std::span<const int> first_node) {
  if (D == 2) return std::make_unique<TwoLevel<2>>(pattern, X, first_node);
  return std::make_unique<TwoLevel<3>>(pattern, X, first_node);
}

template class TwoLevel<2>;
template class TwoLevel<3>;

}  // namespace sim
