// Rows and columns of a matrix by their numbers. Eigen 3.4 and 5 name "all of the others" differently; a sequence of
// numbers is known to both.
#pragma once

#include <Eigen/Core>

namespace sim {

template <class Matrix, class Numbers>
Matrix chosen_columns(const Matrix& m, const Numbers& columns) {
  return m(Eigen::seqN(0, m.rows()), columns);
}

template <class Numbers>
Eigen::MatrixXd chosen_rows(const Eigen::MatrixXd& m, const Numbers& rows) {
  return m(rows, Eigen::seqN(0, m.cols()));
}

}  // namespace sim
