// The sparse symmetric matrix of the system, in D x D blocks, one for each pair of nodes that share an element.
// Stored whole (both halves), row by row (block CSR), so that a product needs no scatter.
#pragma once

#include <Eigen/Core>
#include <compare>
#include <span>
#include <vector>

#include "sim/math/large_array.h"

namespace sim {

// Two nodes, i < j.
struct NodePair {
  int i, j;
  auto operator<=>(const NodePair&) const = default;
};

// Which nodes are coupled; rows sorted, the diagonal always present.
struct BlockPattern {
  std::vector<int> start;  // row i holds column[start[i]] ... column[start[i+1]-1]
  std::vector<int> column;

  // For each block below the diagonal, row by row: its slot and that of the block it mirrors.
  struct Mirrored {
    int slot, upper;
  };
  std::vector<Mirrored> below;

  int rows() const { return static_cast<int>(start.size()) - 1; }
  int blocks() const { return static_cast<int>(column.size()); }
  // Position of block (i, j) in `column`; it must exist.
  int slot(int i, int j) const;
  bool has(int i, int j) const;
};

// Gathers which nodes are coupled, clique by clique, and makes the pattern.
class Coupling {
 public:
  explicit Coupling(int nodes) : nodes_(nodes) {}
  // All pairs of these nodes are coupled.
  void add(std::span<const int> clique);
  BlockPattern pattern() const;

 private:
  int nodes_;
  std::vector<int> start_ = {0};
  std::vector<int> members_;
};

class BlockMatrix {
 public:
  BlockMatrix(const BlockPattern& pattern, int D) : pattern_(&pattern), D_(D), values_(pattern.column.size() * D * D) {}

  const BlockPattern& pattern() const { return *pattern_; }
  int D() const { return D_; }
  LargeArray<double>& values() { return values_; }
  const LargeArray<double>& values() const { return values_; }
  double* block(int slot) { return values_.data() + static_cast<std::size_t>(slot) * D_ * D_; }  // row-major
  const double* block(int slot) const { return values_.data() + static_cast<std::size_t>(slot) * D_ * D_; }

  // All blocks 0, those of the pattern and of these pairs outside of it (any order, any number of times).
  void set_zero(std::vector<NodePair>& outside);
  // Block (i, j), i <= j, of the pattern or of a pair outside of it.
  double* find(int i, int j);
  // The pairs outside of the pattern, sorted, and their values one after the other.
  const std::vector<NodePair>& outside() const { return outside_; }
  const std::vector<double>& outside_values() const { return outside_values_; }
  // Terms fill the blocks (i, j) with i <= j; this copies them to (j, i).
  void mirror(int threads);
  void diagonal(Eigen::VectorXd& d) const;
  // y = A p
  void multiply(const Eigen::VectorXd& p, Eigen::VectorXd& y, int threads) const;

 private:
  const BlockPattern* pattern_;
  int D_;
  LargeArray<double> values_;
  std::vector<NodePair> outside_;
  std::vector<double> outside_values_;
};

}  // namespace sim
