#include "sim/linear/coupled_rows.h"

#include <algorithm>

namespace sim {

// The rows and their pattern. False: there are none.
template <int D>
bool CoupledRows<D>::gather(const FloatMatrix<D>& A) {
  rows_.clear();
  for (const auto& block : A.outside())
    if (rows_.empty() || rows_.back() != block.row) rows_.push_back(block.row);
  if (rows_.empty()) return false;
  number_.assign(A.rows(), -1);
  for (std::size_t k = 0; k < rows_.size(); ++k) number_[rows_[k]] = static_cast<int>(k);
  std::swap(pattern_, before_);
  pattern_.start.assign(1, 0);
  pattern_.column.clear();
  std::size_t out = 0;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const int i = rows_[k], own = static_cast<int>(k);
    const auto first = pattern_.start.back();
    for (int m = A.begin(i); m < A.end(i) - 1; ++m)
      if (number_[A.column(m)] >= own) pattern_.column.push_back(number_[A.column(m)]);
    for (; out < A.outside().size() && A.outside()[out].row == i; ++out)
      if (const int column = number_[A.outside()[out].column]; column > own) pattern_.column.push_back(column);
    std::sort(pattern_.column.begin() + first, pattern_.column.end());
    pattern_.start.push_back(pattern_.blocks());
  }
  return true;
}

template <int D>
void CoupledRows<D>::fill(const FloatMatrix<D>& A) {
  using Square = Eigen::Matrix<double, D, D, Eigen::RowMajor>;
  std::fill(matrix_.values().begin(), matrix_.values().end(), 0.0);
  std::size_t out = 0;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const int i = rows_[k], own = static_cast<int>(k);
    // The last block of a row belongs to its diagonal as well.
    for (int m = A.begin(i); m < A.end(i); ++m)
      if (const int column = number_[A.column(m)]; column >= own)
        Eigen::Map<Square>(matrix_.block(pattern_.slot(own, column))) += A.block(m).template cast<double>();
    for (; out < A.outside().size() && A.outside()[out].row == i; ++out)
      if (const int column = number_[A.outside()[out].column]; column > own)
        Eigen::Map<Square>(matrix_.block(pattern_.slot(own, column))) += A.outside()[out].block;
  }
}

template <int D>
void CoupledRows<D>::make(const FloatMatrix<D>& A, const Eigen::VectorXd& free) {
  if (!gather(A)) return;
  const auto size = static_cast<Eigen::Index>(rows_.size()) * D;
  free_.resize(size);
  r_.resize(size);
  z_.resize(size);
  for (std::size_t k = 0; k < rows_.size(); ++k)
    free_.segment<D>(static_cast<Eigen::Index>(k) * D) = free.segment<D>(static_cast<Eigen::Index>(rows_[k]) * D);
  matrix_.values().resize(pattern_.column.size() * D * D);
  fill(A);
  if (!is_analysed_ || pattern_.start != before_.start || pattern_.column != before_.column ||
      free_ != analysed_free_) {
    is_analysed_ = cholesky_.analyse(matrix_, free_);
    analysed_free_ = free_;
  }
  if (!is_analysed_ || cholesky_.factorise(matrix_) != Cholesky::Status::done) rows_.clear();
}

template <int D>
double CoupledRows<D>::solve(const Eigen::Ref<const Eigen::VectorXd>& r) {
  if (rows_.empty()) return 0;
  for (std::size_t k = 0; k < rows_.size(); ++k)
    r_.segment<D>(static_cast<Eigen::Index>(k) * D) = r.segment<D>(static_cast<Eigen::Index>(rows_[k]) * D);
  cholesky_.solve(r_, z_);
  return r_.dot(z_);
}

template class CoupledRows<2>;
template class CoupledRows<3>;

}  // namespace sim
