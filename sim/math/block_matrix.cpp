#include "sim/math/block_matrix.h"

#include <algorithm>
#include <cassert>

namespace sim {

int BlockPattern::slot(int i, int j) const {
  const auto begin = column.begin() + start[i], end = column.begin() + start[i + 1];
  const auto at = std::lower_bound(begin, end, j);
  assert(at != end && *at == j);
  return static_cast<int>(at - column.begin());
}

bool BlockPattern::has(int i, int j) const {
  return std::binary_search(column.begin() + start[i], column.begin() + start[i + 1], j);
}

void Coupling::add(std::span<const int> clique) {
  members_.insert(members_.end(), clique.begin(), clique.end());
  start_.push_back(static_cast<int>(members_.size()));
}

BlockPattern Coupling::pattern() const {
  // The cliques of each node, by counting.
  std::vector<int> first(nodes_ + 1, 0);
  for (const int node : members_) ++first[node + 1];
  for (int i = 0; i < nodes_; ++i) first[i + 1] += first[i];
  std::vector<int> cliques(members_.size()), next(first.begin(), first.end() - 1);
  for (int c = 0; c + 1 < static_cast<int>(start_.size()); ++c)
    for (int m = start_[c]; m < start_[c + 1]; ++m) cliques[next[members_[m]]++] = c;

  BlockPattern pattern;
  pattern.start.reserve(nodes_ + 1);
  pattern.start.push_back(0);
  std::vector<int> row;
  for (int i = 0; i < nodes_; ++i) {
    row.assign(1, i);
    for (int k = first[i]; k < first[i + 1]; ++k)
      row.insert(row.end(), members_.begin() + start_[cliques[k]], members_.begin() + start_[cliques[k] + 1]);
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    pattern.column.insert(pattern.column.end(), row.begin(), row.end());
    pattern.start.push_back(static_cast<int>(pattern.column.size()));
  }
  for (int i = 0; i < nodes_; ++i)
    for (int k = pattern.start[i]; pattern.column[k] < i; ++k)
      pattern.below.push_back({k, pattern.slot(pattern.column[k], i)});
  return pattern;
}

void BlockMatrix::set_zero(std::vector<NodePair>& outside) {
  std::fill(values_.begin(), values_.end(), 0.0);
  std::sort(outside.begin(), outside.end());
  outside.erase(std::unique(outside.begin(), outside.end()), outside.end());
  std::erase_if(outside, [&](const NodePair& pair) { return pattern_->has(pair.i, pair.j); });
  outside_.assign(outside.begin(), outside.end());
  outside_values_.assign(outside_.size() * static_cast<std::size_t>(D_) * D_, 0.0);
}

double* BlockMatrix::find(int i, int j) {
  const auto at = std::lower_bound(outside_.begin(), outside_.end(), NodePair{i, j});
  if (at == outside_.end() || *at != NodePair{i, j}) return block(pattern_->slot(i, j));
  return outside_values_.data() + static_cast<std::size_t>(at - outside_.begin()) * D_ * D_;
}

void BlockMatrix::mirror(int threads) {
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t m = 0; m < pattern_->below.size(); ++m) {
    double* to = block(pattern_->below[m].slot);
    const double* from = block(pattern_->below[m].upper);
    for (int i = 0; i < D_; ++i)
      for (int j = 0; j < D_; ++j) to[j * D_ + i] = from[i * D_ + j];
  }
}

namespace {

template <int D>
void multiply_blocks(const BlockPattern& pattern, const double* values, const double* p, double* y, int threads) {
#pragma omp parallel for schedule(static) num_threads(threads)
  for (int i = 0; i < pattern.rows(); ++i) {
    double sum[D] = {};
    for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
      const double* block = values + static_cast<std::size_t>(k) * D * D;
      const double* pj = p + static_cast<std::size_t>(pattern.column[k]) * D;
      for (int r = 0; r < D; ++r)
        for (int c = 0; c < D; ++c) sum[r] += block[r * D + c] * pj[c];
    }
    for (int r = 0; r < D; ++r) y[static_cast<std::size_t>(i) * D + r] = sum[r];
  }
}

}  // namespace

void BlockMatrix::diagonal(Eigen::VectorXd& d) const {
  for (int i = 0; i < pattern_->rows(); ++i) {
    const double* own = block(pattern_->slot(i, i));
    for (int c = 0; c < D_; ++c) d[static_cast<Eigen::Index>(i) * D_ + c] = own[c * D_ + c];
  }
}

void BlockMatrix::multiply(const Eigen::VectorXd& p, Eigen::VectorXd& y, int threads) const {
  if (D_ == 2)
    multiply_blocks<2>(*pattern_, values_.data(), p.data(), y.data(), threads);
  else
    multiply_blocks<3>(*pattern_, values_.data(), p.data(), y.data(), threads);
  for (std::size_t k = 0; k < outside_.size(); ++k) {
    const double* block = outside_values_.data() + k * D_ * D_;
    const Eigen::Index i = static_cast<Eigen::Index>(outside_[k].i) * D_,
                       j = static_cast<Eigen::Index>(outside_[k].j) * D_;
    for (int r = 0; r < D_; ++r)
      for (int c = 0; c < D_; ++c) {
        y[i + r] += block[r * D_ + c] * p[j + c];
        y[j + c] += block[r * D_ + c] * p[i + r];
      }
  }
}

}  // namespace sim
