// A block matrix as one of Eigen's, for eigenvalue and other solvers that work on those.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "sim/math/block_matrix.h"

namespace sim {

using SparseMatrix = Eigen::SparseMatrix<double>;

// The free rows and columns of a block matrix.
inline SparseMatrix free_part(const BlockMatrix& A, const Eigen::VectorXd& free) {
  const int D = A.D();
  std::vector<int> number(free.size(), -1);
  int count = 0;
  for (Eigen::Index i = 0; i < free.size(); ++i)
    if (free[i] != 0) number[i] = count++;
  std::vector<Eigen::Triplet<double>> entries;
  const BlockPattern& pattern = A.pattern();
  for (int i = 0; i < pattern.rows(); ++i)
    for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
      for (int r = 0; r < D; ++r)
        for (int c = 0; c < D; ++c) {
          const int row = number[i * D + r], column = number[pattern.column[k] * D + c];
          if (row >= 0 && column >= 0) entries.emplace_back(row, column, A.block(k)[r * D + c]);
        }
  SparseMatrix B(count, count);
  B.setFromTriplets(entries.begin(), entries.end());
  return B;
}

}  // namespace sim
