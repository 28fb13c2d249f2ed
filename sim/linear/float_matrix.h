// The matrix of the system in single precision, for products: half the memory to read, which is what they wait for.
//
//   A_ij = F_ij + (A_ij - F_ij),  F_ij = A_ij rounded to float;  y_i = sum_j F_ij p_j + c_i p_i,
//   c_i = sym sum_j (A_ij - F_ij)
//
// Rounding alone changes p'Ap by 6e-8 of |A| |p|^2, more than all the energy of a slender body's bending. With c_i the
// sums of the rows are those of A, so that p'Ap = -1/2 sum_ij (p_i - p_j)' F_ij (p_i - p_j) + (exact): the change is
// 6e-8 of the energy of differences between neighbours; translations, masses and springs are exact to double.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/math/block_matrix.h"

namespace sim {

template <int D>
class FloatMatrix {
 public:
  using Block = Eigen::Map<const Eigen::Matrix<float, D, D>>;  // column by column
  using Inverse = Eigen::Matrix<float, D, D>;
  // A block outside of the pattern: few, they stay in double.
  struct Outside {
    int row, column;
    Eigen::Matrix<double, D, D> block;
  };

  // Row k here is row order[k] there.
  FloatMatrix(const BlockPattern& pattern, const std::vector<int>& order);

  // Components where free is 0 (in the order here) get rows and columns of zeros.
  void restrict_to(const Eigen::VectorXd& free);
  // Takes the blocks (i, j), i <= j there, of the pattern and outside of it; the others are their transposes.
  void take(const BlockMatrix& A, int threads);
  // The power of two that all of A was multiplied by, to stay within the range of float.
  double scale() const { return scale_; }

  // Rows first ... last-1 of y = A p, blocks outside of the pattern included; returns their part of p . y. p has a
  // number more than it needs: it is read in fours.
  double multiply(int first, int last, const double* p, double* y) const;
  // Inverse of A_ii; 1 on components that are not free. Where A_ii is not positive definite, that of its absolute
  // diagonal.
  const Inverse& inverse(int i) const { return inverse_[i]; }

  int rows() const { return static_cast<int>(start_.size()) - 1; }
  // Row i has blocks begin(i) ... end(i)-1 by rising column; then, as one more block of column i, its c_i.
  int begin(int i) const { return start_[i]; }
  int end(int i) const { return start_[i + 1]; }
  int column(int k) const { return column_[k]; }
  Block block(int k) const { return Block(values_.data() + static_cast<std::size_t>(k) * D * D); }

  // Both halves, by row, then by column.
  const std::vector<Outside>& outside() const { return outside_; }
  // Where those of a row begin.
  std::size_t first_outside(int row) const;

  static std::int64_t bytes(std::int64_t rows, std::int64_t blocks) {
    return (blocks + rows) * (D * D * 4 + 8) + rows * (D * D * 4 + 5 + D * 8);
  }

 private:
  void take_row(int i, const BlockMatrix& A);
  void take_outside(const BlockMatrix& A);
  double multiply_outside(int first, int last, const double* p, double* y) const;
  void leave_out(int i, double (&diagonal)[D * D]);

  std::vector<int> number_;  // here, of each row there
  std::vector<int> start_;
  LargeArray<int> column_;
  LargeArray<int> source_;  // slot there; ~slot where its transpose is meant
  LargeArray<float> values_;
  LargeArray<Inverse> inverse_;
  std::vector<Outside> outside_;
  Eigen::VectorXd free_;
  std::vector<char> touched_;  // row i has a component that is not free, or is coupled with one
  double scale_ = 1;
};

}  // namespace sim
