#include "sim/residual/reference.h"

#include <Eigen/LU>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <memory>

#include "sim/residual/grid.h"
#include "sim/residual/legendre.h"
#include "sim/residual/rule.h"

// u' = s/k, s' = a s/k + q u - f with s = k u': no derivative of k is needed, and both are smooth where the data are.
// Implicit Runge-Kutta with Gauss's points on each panel is polynomial collocation there [Ascher, Mattheij & Russell
// 1995, 5.3]; every panel maps (u, s) from its left to its right end, and all of them together with u(0) = u(1) = 0 are
// one system, which is stable where shooting from one end is not.
namespace sim::residual {
namespace {

constexpr int stages = 16;
constexpr int doublings = 12;  // rounds of halving
constexpr std::size_t most_pieces = 400;
constexpr Real resolved_tail =
    1e-16L;  // of the largest |u'|, |s'|: what the last coefficients of a resolved panel have

constexpr Real most_change = 1e-6L;
const char* const not_unique = "L u = f has no solution that is the only one";

using Pair = Eigen::Matrix<Real, 2, 1>;
using Block = Eigen::Matrix<Real, 2, 2>;

// int from -1 to t of P_m = (P_{m+1} - P_{m-1})/(2m + 1), of P_0: t + 1
Real integral_of(int m, Real t, const Legendre& after, const Legendre& P) {
  return m == 0 ? t + 1 : (after.value - P.before) / (2 * m + 1);
}

// I_jm = int from -1 to t_j of the Lagrange polynomial m, exactly: in Legendre polynomials, whose integrals are known.
struct Collocation {
  Rule rule = gauss_legendre(stages);
  Matrix to_legendre{stages, stages};  // values at the points -> coefficients of P_0 ... P_15
  Matrix integral{stages, stages};

  Collocation() {
    Matrix integrals(stages, stages);  // of P_m up to t_j
    for (int j = 0; j < stages; ++j)
      for (int m = 0; m < stages; ++m) {
        to_legendre(m, j) = rule.weight[j] * (2 * m + 1) / 2 * legendre(m, rule.t[j]).value;
        integrals(j, m) = integral_of(m, rule.t[j], legendre(m + 1, rule.t[j]), legendre(m, rule.t[j]));
      }
    integral = integrals * to_legendre;
  }
};

// y' = B y + g on a panel; the values of y' at its points are affine in y at its left end.
struct Piece {
  Real low = 0, high = 0;
  Matrix slopes;  // of u, then of s, at the points: columns for u(low) = 1, for s(low) = 1, for g
  Block step;     // (u, s)(high) = step (u, s)(low) + shift
  Pair shift;
};

Piece make_piece(const Problem& problem, const Collocation& collocation, Real low, Real high) {
  const Real half = (high - low) / 2;
  const Matrix I = half * collocation.integral;
  Matrix A = Matrix::Identity(2 * stages, 2 * stages), right = Matrix::Zero(2 * stages, 3);
  for (int j = 0; j < stages; ++j) {
    const Real x = low + half * (1 + collocation.rule.t[j]), k = problem.k(x).value;
    const Real by_s = 1 / k, s_by_s = problem.a(x).value / k, s_by_u = problem.q(x).value;
    A.row(j).tail(stages) -= by_s * I.row(j);
    A.row(stages + j).head(stages) -= s_by_u * I.row(j);
    A.row(stages + j).tail(stages) -= s_by_s * I.row(j);
    right(j, 1) = by_s;
    right.row(stages + j) << s_by_u, s_by_s, -problem.f(x).value;
  }
  Piece piece{low, high, Eigen::PartialPivLU<Matrix>(A).solve(right), Block::Identity(), Pair::Zero()};
  for (int component = 0; component < 2; ++component) {
    const Eigen::Matrix<Real, 1, 3> sum =
        half * collocation.rule.weight.transpose() * piece.slopes.middleRows(component * stages, stages);
    piece.step.row(component) += sum.head<2>();
    piece.shift[component] = sum[2];
  }
  return piece;
}

// (u, s) at every end of a panel, from u(0) = 0, y_{i+1} - step_i y_i = shift_i, u(1) = 0.
std::vector<Pair> join(const std::vector<Piece>& pieces) {
  const int count = static_cast<int>(pieces.size()), size = 2 * count + 2;
  std::vector<Eigen::Triplet<Real>> entries = {{0, 0, 1}, {size - 1, 2 * count, 1}};
  Vector b = Vector::Zero(size);
  for (int i = 0; i < count; ++i) {
    for (int r = 0; r < 2; ++r) {
      for (int c = 0; c < 2; ++c) entries.emplace_back(2 * i + 1 + r, 2 * i + c, -pieces[i].step(r, c));
      entries.emplace_back(2 * i + 1 + r, 2 * i + 2 + r, 1);
    }
    b.segment<2>(2 * i + 1) = pieces[i].shift;
  }
  Eigen::SparseMatrix<Real> A(size, size);
  A.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<Real>> lu(A);
  if (lu.info() != Eigen::Success) throw ProblemError("f", not_unique);
  const Vector y = lu.solve(b);
  std::vector<Pair> ends;
  for (Eigen::Index i = 0; i <= count; ++i) ends.push_back(y.segment<2>(2 * i));
  return ends;
}

// The slopes of u and s on every panel, in Legendre polynomials.
struct Curve {
  std::vector<Real> ends;
  std::vector<Pair> y;  // there
  std::vector<Eigen::Matrix<Real, Eigen::Dynamic, 2>> slopes;

  Jet at(Real x) const {
    const auto after = std::upper_bound(ends.begin() + 1, ends.end() - 1, x);
    const std::size_t i = after - ends.begin() - 1;
    const Real half = (ends[i + 1] - ends[i]) / 2, t = (x - ends[i]) / half - 1;
    Jet u{y[i][0], 0};
    Legendre P;
    for (int m = 0; m < stages; ++m) {
      const Legendre after = next(P, m, t);
      u.value += half * slopes[i](m, 0) * integral_of(m, t, after, P);
      u.slope += slopes[i](m, 0) * P.value;
      P = after;
    }
    return u;
  }
};

Curve make_curve(const Problem& problem, const Collocation& collocation, const std::vector<Real>& ends) {
  std::vector<Piece> pieces;
  for (std::size_t i = 1; i < ends.size(); ++i)
    pieces.push_back(make_piece(problem, collocation, ends[i - 1], ends[i]));
  Curve curve{ends, join(pieces), {}};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Vector slopes = pieces[i].slopes * Eigen::Matrix<Real, 3, 1>(curve.y[i][0], curve.y[i][1], 1);
    curve.slopes.emplace_back(collocation.to_legendre * slopes.reshaped(stages, 2));
  }
  return curve;
}

// The ends with the middle of every panel on which the curve is not resolved.
std::vector<Real> halved(const Curve& curve) {
  Pair scale = Pair::Zero();
  for (const auto& slopes : curve.slopes) scale = scale.cwiseMax(slopes.cwiseAbs().colwise().maxCoeff().transpose());
  std::vector<Real> ends = {0};
  for (std::size_t i = 0; i < curve.slopes.size(); ++i) {
    const Pair tail = curve.slopes[i].bottomRows(2).cwiseAbs().colwise().maxCoeff();
    if ((tail.array() > resolved_tail * scale.array()).any()) ends.push_back((curve.ends[i] + curve.ends[i + 1]) / 2);
    ends.push_back(curve.ends[i + 1]);
  }
  return ends;
}

Real apart(const Curve& one, const Curve& other) {
  constexpr int cells = 1000;
  Real most = 0, size = 0;
  for (int i = 0; i <= cells; ++i) {
    const Real u = one.at(Real(i) / cells).value;
    size = std::max(size, std::abs(u));
    most = std::max(most, std::abs(u - other.at(Real(i) / cells).value));
  }
  return size > 0 ? most / size : 0;
}

std::vector<Real> all_halved(const std::vector<Real>& ends) {
  std::vector<Real> fine = {ends.front()};
  for (std::size_t i = 1; i < ends.size(); ++i) fine.insert(fine.end(), {(ends[i - 1] + ends[i]) / 2, ends[i]});
  return fine;
}

}  // namespace

Reference compute_reference(const Problem& problem) {
  const Collocation collocation;
  Problem data = problem;
  data.exact = nullptr;
  std::vector<Real> ends = make_panels(data, 1);
  auto curve = std::make_shared<Curve>(make_curve(problem, collocation, ends));
  for (int round = 0; round < doublings; ++round) {
    const std::vector<Real> finer = halved(*curve);
    if (finer.size() == ends.size() || finer.size() > most_pieces) break;
    ends = finer;
    *curve = make_curve(problem, collocation, ends);
  }
  const Curve check = make_curve(problem, collocation, all_halved(ends));
  const Real change = apart(check, *curve);
  if (!(change < most_change))
    throw ProblemError("f", std::string(not_unique) + ", or it is too steep: " + std::to_string(ends.size() - 1) +
                                " panels of " + std::to_string(stages) + " points do not resolve it");
  const int panels = static_cast<int>(ends.size()) - 1;
  return {[curve = std::shared_ptr<const Curve>(curve)](Real x) { return curve->at(x); }, panels, stages, change};
}

}  // namespace sim::residual
