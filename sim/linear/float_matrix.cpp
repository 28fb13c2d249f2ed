#include "sim/linear/float_matrix.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace sim {

template <int D>
FloatMatrix<D>::FloatMatrix(const BlockPattern& pattern, const std::vector<int>& order) : number_(order.size()) {
  const int n = pattern.rows();
  std::vector<int> upper(pattern.blocks());
  for (int k = 0; k < n; ++k) number_[order[k]] = k;
  std::iota(upper.begin(), upper.end(), 0);
  for (const BlockPattern::Mirrored& m : pattern.below) upper[m.slot] = ~m.upper;
  start_.reserve(n + 1);
  column_.reserve(pattern.blocks() + n);
  source_.reserve(pattern.blocks() + n);
  start_.push_back(0);
  std::vector<std::pair<int, int>> row;  // column here, source
  for (int i = 0; i < n; ++i) {
    row.clear();
    for (int k = pattern.start[order[i]]; k < pattern.start[order[i] + 1]; ++k)
      row.emplace_back(number_[pattern.column[k]], upper[k]);
    std::sort(row.begin(), row.end());
    for (const auto& [column, source] : row) {
      column_.push_back(column);
      source_.push_back(source);
    }
    column_.push_back(i);
    source_.push_back(0);
    start_.push_back(static_cast<int>(column_.size()));
  }
  values_.resize(column_.size() * D * D);
  inverse_.resize(n);
  restrict_to(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(n) * D));
}

template <int D>
void FloatMatrix<D>::restrict_to(const Eigen::VectorXd& free) {
  free_ = free;
  touched_.assign(rows(), 0);
  for (int i = 0; i < rows(); ++i)
    for (int k = begin(i); k < end(i); ++k)
      if ((free.segment<D>(static_cast<Eigen::Index>(column(k)) * D).array() == 0).any()) touched_[i] = 1;
}

template <int D>
void FloatMatrix<D>::take(const BlockMatrix& A, int threads) {
  // Any entry of the diagonal tells the order of magnitude; a power of two changes no bit.
  const double first = std::abs(A.block(A.pattern().slot(0, 0))[0]);
  scale_ = first > 0 && std::isfinite(first) ? std::exp2(-std::ilogb(first)) : 1;
#pragma omp parallel for schedule(static) num_threads(threads)
  for (int i = 0; i < rows(); ++i) take_row(i, A);
  take_outside(A);
}

template <int D>
void FloatMatrix<D>::take_outside(const BlockMatrix& A) {
  using Square = Eigen::Matrix<double, D, D, Eigen::RowMajor>;
  outside_.clear();
  const auto free_of = [&](int i) { return free_.segment<D>(static_cast<Eigen::Index>(i) * D); };
  for (std::size_t k = 0; k < A.outside().size(); ++k) {
    const int i = number_[A.outside()[k].i], j = number_[A.outside()[k].j];
    const Eigen::Map<const Square> there(A.outside_values().data() + k * D * D);
    const Eigen::Matrix<double, D, D> block = scale_ * (free_of(i).asDiagonal() * there * free_of(j).asDiagonal());
    outside_.push_back({i, j, block});
    outside_.push_back({j, i, block.transpose()});
  }
  std::sort(outside_.begin(), outside_.end(), [](const Outside& a, const Outside& b) {
    return a.row < b.row || (a.row == b.row && a.column < b.column);
  });
}

template <int D>
std::size_t FloatMatrix<D>::first_outside(int row) const {
  const auto at = std::lower_bound(outside_.begin(), outside_.end(), row,
                                   [](const Outside& block, int value) { return block.row < value; });
  return static_cast<std::size_t>(at - outside_.begin());
}

namespace {

// to = s times from, rounded; what that loses is added to `lost`. In fours by hand: GCC 12 drops the rounding from the
// loss where it vectorises this by itself.
template <int D>
void round_block(const double* from, double s, float* to, double* lost) {
  typedef double Doubles __attribute__((vector_size(32)));
  typedef float Floats __attribute__((vector_size(16)));
  constexpr int whole = D * D / 4 * 4;
  for (int m = 0; m < whole; m += 4) {
    Doubles exact, sum;
    std::memcpy(&exact, from + m, sizeof exact);
    std::memcpy(&sum, lost + m, sizeof sum);
    exact *= s;
    const Floats rounded = __builtin_convertvector(exact, Floats);
    sum += exact - __builtin_convertvector(rounded, Doubles);
    std::memcpy(to + m, &rounded, sizeof rounded);
    std::memcpy(lost + m, &sum, sizeof sum);
  }
  for (int m = whole; m < D * D; ++m) {
    to[m] = static_cast<float>(s * from[m]);
    lost[m] += s * from[m] - static_cast<double>(to[m]);
  }
}

}  // namespace

template <int D>
void FloatMatrix<D>::take_row(int i, const BlockMatrix& A) {
  const auto value = [&](int k) { return values_.data() + static_cast<std::size_t>(k) * D * D; };
  const int last = end(i) - 1;
  double straight[D * D] = {}, turned[D * D] = {};  // lost by rounding, as stored there
  double diagonal[D * D] = {};
  for (int k = begin(i); k < last; ++k) {
    const bool transposed = source_[k] < 0;
    const double* from = A.block(transposed ? ~source_[k] : source_[k]);
    float* to = value(k);
    float rounded[D * D];
    round_block<D>(from, scale_, rounded, transposed ? turned : straight);
    // Rows there are columns of the transpose.
    if (transposed)
      std::memcpy(to, rounded, sizeof rounded);
    else
      for (int c = 0; c < D; ++c)
        for (int r = 0; r < D; ++r) to[c * D + r] = rounded[r * D + c];
    if (column_[k] == i)
      for (int m = 0; m < D * D; ++m) diagonal[m] = scale_ * from[m];
  }
  float* correction = value(last);
  for (int r = 0; r < D; ++r)
    for (int c = 0; c < D; ++c)
      correction[c * D + r] =
          static_cast<float>(0.5 * (straight[r * D + c] + straight[c * D + r] + turned[r * D + c] + turned[c * D + r]));
  if (touched_[i]) leave_out(i, diagonal);
  using Square = Eigen::Matrix<double, D, D>;
  const Square own = Eigen::Map<const Square>(diagonal);
  bool definite = own(0, 0) > 0 && own(0, 0) * own(1, 1) > own(0, 1) * own(1, 0);
  if constexpr (D == 3) definite = definite && own.determinant() > 0;
  if (definite) {
    const Square inverse = own.inverse();
    inverse_[i] = (0.5 * (inverse + inverse.transpose())).template cast<float>();
  } else {
    inverse_[i].setZero();
    for (int c = 0; c < D; ++c) inverse_[i](c, c) = static_cast<float>(1 / std::max(std::abs(own(c, c)), 1e-30));
  }
}

template <int D>
void FloatMatrix<D>::leave_out(int i, double (&diagonal)[D * D]) {
  const double* own = free_.data() + static_cast<std::size_t>(i) * D;
  for (int k = begin(i); k < end(i); ++k) {
    const double* other = free_.data() + static_cast<std::size_t>(column_[k]) * D;
    for (int c = 0; c < D; ++c)
      for (int r = 0; r < D; ++r)
        if (own[r] == 0 || other[c] == 0) values_[static_cast<std::size_t>(k) * D * D + c * D + r] = 0;
  }
  for (int c = 0; c < D; ++c)
    for (int r = 0; r < D; ++r)
      if (own[r] == 0 || own[c] == 0) diagonal[c * D + r] = r == c ? 1 : 0;
}

namespace {

// y = sum over the blocks of a row, block (columns beside each other) times p of its column: the numbers of a block are
// multiplied side by side with their p's, and added up once at the row's end.
template <int D>
struct RowSum;

template <>
struct RowSum<3> {
  typedef float Floats __attribute__((vector_size(32)));
  typedef double Doubles __attribute__((vector_size(64)));
  typedef double Four __attribute__((vector_size(32)));
  Doubles sum = {};
  double last = 0;

  void add(const float* block, const double* p) {
    Floats floats;
    Four four;
    std::memcpy(&floats, block, sizeof floats);
    std::memcpy(&four, p, sizeof four);
    sum += __builtin_convertvector(floats, Doubles) * __builtin_shufflevector(four, four, 0, 0, 0, 1, 1, 1, 2, 2);
    last += static_cast<double>(block[8]) * p[2];
  }
  double finish(const double* p, double* y) const {
    y[0] = sum[0] + sum[3] + sum[6];
    y[1] = sum[1] + sum[4] + sum[7];
    y[2] = sum[2] + sum[5] + last;
    return p[0] * y[0] + p[1] * y[1] + p[2] * y[2];
  }
};

template <>
struct RowSum<2> {
  typedef float Floats __attribute__((vector_size(16)));
  typedef double Doubles __attribute__((vector_size(32)));
  Doubles sum = {};

  void add(const float* block, const double* p) {
    Floats floats;
    std::memcpy(&floats, block, sizeof floats);
    sum += __builtin_convertvector(floats, Doubles) * Doubles{p[0], p[0], p[1], p[1]};
  }
  double finish(const double* p, double* y) const {
    y[0] = sum[0] + sum[2];
    y[1] = sum[1] + sum[3];
    return p[0] * y[0] + p[1] * y[1];
  }
};

}  // namespace

template <int D>
double FloatMatrix<D>::multiply(int first, int last, const double* p, double* y) const {
  double pAp = 0;
  for (int i = first; i < last; ++i) {
    RowSum<D> row;
    for (int k = begin(i); k < end(i); ++k)
      row.add(values_.data() + static_cast<std::size_t>(k) * D * D, p + static_cast<std::size_t>(column_[k]) * D);
    const std::size_t at = static_cast<std::size_t>(i) * D;
    pAp += row.finish(p + at, y + at);
  }
  return outside_.empty() ? pAp : pAp + multiply_outside(first, last, p, y);
}

template <int D>
double FloatMatrix<D>::multiply_outside(int first, int last, const double* p, double* y) const {
  using Node = Eigen::Matrix<double, D, 1>;
  double pAp = 0;
  for (std::size_t k = first_outside(first); k < outside_.size() && outside_[k].row < last; ++k) {
    const std::size_t at = static_cast<std::size_t>(outside_[k].row) * D;
    const Node part = outside_[k].block * Eigen::Map<const Node>(p + static_cast<std::size_t>(outside_[k].column) * D);
    Eigen::Map<Node>(y + at) += part;
    pAp += Eigen::Map<const Node>(p + at).dot(part);
  }
  return pAp;
}

template class FloatMatrix<2>;
template class FloatMatrix<3>;

}  // namespace sim
