#include "sim/reduce/lift.h"

#include <algorithm>

namespace sim {

namespace {

// Nodes are shared out in as many parts, whatever the number of threads.
constexpr int most_chunks = 16;
constexpr int fewest_nodes = 64;  // of a chunk

// y += s x
inline void add_scaled(Eigen::Index n, double s, const double* x, double* y) {
  for (Eigen::Index q = 0; q < n; ++q) y[q] += s * x[q];
}

// The part of R += u^T y right of the diagonal, where the sum of all of them is symmetric.
inline void add_outer(Eigen::Index n, const double* u, const double* y, Eigen::MatrixXd& R) {
  for (Eigen::Index q = 0; q < n; ++q) add_scaled(q + 1, y[q], u, R.col(q).data());
}

}  // namespace

void Lift::place(const Eigen::VectorXd& c, Eigen::VectorXd& x) const {
  x = X_;
  x.noalias() += U_ * c;
}

void Lift::move(const Eigen::VectorXd& dc, Eigen::VectorXd& v) const {
  v.setZero(U_.rows());
  v.noalias() += U_ * dc;
}

void Lift::gather(const Eigen::VectorXd& f, Eigen::VectorXd& g) const {
  g.noalias() += U_.transpose() * f;
}

// sum over the nodes i of U_i^T (K U)_i
void Lift::reduce_rows(const BlockMatrix& K, int first, int last, Rows& KU, Eigen::MatrixXd& R) const {
  const BlockPattern& pattern = K.pattern();
  const int D = K.D();
  const Eigen::Index r = U_.cols();
  for (int i = first; i < last; ++i) {
    KU.setZero();
    for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
      const double* block = K.block(k);
      const Eigen::Index j = static_cast<Eigen::Index>(pattern.column[k]) * D;
      for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) add_scaled(r, block[a * D + b], U_.row(j + b).data(), KU.row(a).data());
    }
    for (int a = 0; a < D; ++a) add_outer(r, U_.row(static_cast<Eigen::Index>(i) * D + a).data(), KU.row(a).data(), R);
  }
}

// Pairs that the pattern does not have stand on one side of the diagonal only: U_i^T B U_j and its transpose.
void Lift::add_outside(const BlockMatrix& K, Rows& KU, Eigen::MatrixXd& R) const {
  const int D = K.D();
  const Eigen::Index r = U_.cols();
  const double* block = K.outside_values().data();
  for (const auto& [i, j] : K.outside()) {
    KU.setZero();
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b)
        add_scaled(r, block[a * D + b], U_.row(static_cast<Eigen::Index>(j) * D + b).data(), KU.row(a).data());
    for (int a = 0; a < D; ++a) {
      const double* u = U_.row(static_cast<Eigen::Index>(i) * D + a).data();
      add_outer(r, u, KU.row(a).data(), R);
      add_outer(r, KU.row(a).data(), u, R);
    }
    block += D * D;
  }
}

void Lift::reduce(const BlockMatrix& K, int threads, Scratch& scratch, Eigen::MatrixXd& R) const {
  const int nodes = K.pattern().rows();
  const int chunks = std::clamp(nodes / fewest_nodes, 1, most_chunks);
  scratch.product.resize(static_cast<std::size_t>(chunks));
  scratch.part.resize(static_cast<std::size_t>(chunks));
#pragma omp parallel for schedule(static) num_threads(threads)
  for (int k = 0; k < chunks; ++k) {
    Rows& KU = scratch.product[static_cast<std::size_t>(k)];
    Eigen::MatrixXd& part = scratch.part[static_cast<std::size_t>(k)];
    KU.setZero(K.D(), U_.cols());
    part.setZero(U_.cols(), U_.cols());
    reduce_rows(K, nodes * k / chunks, nodes * (k + 1) / chunks, KU, part);
  }
  R = scratch.part[0];
  for (std::size_t k = 1; k < scratch.part.size(); ++k) R += scratch.part[k];
  add_outside(K, scratch.product[0], R);
}

}  // namespace sim
