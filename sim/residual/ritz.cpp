#include <Eigen/Cholesky>

#include "sim/residual/grid.h"
#include "sim/residual/method.h"
#include "sim/residual/rule.h"

// Shares no integral with Galerkin's method, so that their agreement proves something: another rule (Fejér's), and
// second derivatives of F instead of int u_i L u_j.
namespace sim::residual {
namespace {

constexpr int fejer_points = 40;  // a panel: the degree that is exact is that of 20 Gauss points

// F(c) = c.H c/2 - g.c
struct Quadratic {
  Matrix H;
  Vector g;
};

// The density of F at x is quadratic in u = sum c_i u_i and u' = sum c_i u_i'. Its second derivatives by c_i and c_j
// are k u_i' u_j' + a (u_i u_j' + u_i' u_j)/2 + q u_i u_j, those at c = 0 of first order -f u_i.
void add_point(const Problem& problem, Real x, Real weight, std::span<const Sample> u, Quadratic& F) {
  const Real k = problem.k(x).value, a = problem.a(x).value, q = problem.q(x).value, f = problem.f(x).value;
  for (std::size_t j = 0; j < u.size(); ++j) {
    if (u[j].value == 0 && u[j].slope == 0) continue;  // a hat elsewhere
    const Real by_slope = weight * (k * u[j].slope + a * u[j].value / 2),
               by_value = weight * (q * u[j].value + a * u[j].slope / 2);
    for (std::size_t i = j; i < u.size(); ++i) F.H(i, j) += by_slope * u[i].slope + by_value * u[i].value;
    F.g[j] += weight * f * u[j].value;
  }
}

}  // namespace

Answer ritz(const Problem& problem, const Basis& basis, int n) {
  const std::vector<Real> ends = make_panels(problem, n);
  const Rule rule = fejer(fejer_points);
  Quadratic F{Matrix::Zero(n, n), Vector::Zero(n)};
  std::vector<Sample> u(n);
  for (std::size_t panel = 1; panel < ends.size(); ++panel) {
    const Real half = (ends[panel] - ends[panel - 1]) / 2;
    for (int p = 0; p < fejer_points; ++p) {
      const Real x = ends[panel - 1] + half * (1 + rule.t[p]);
      basis.sample(x, u);
      add_point(problem, x, half * rule.weight[p], u, F);
    }
  }
  const Eigen::LLT<Matrix, Eigen::Lower> cholesky(F.H);  // reads the lower triangle only
  if (cholesky.info() != Eigen::Success)
    return {{}, "F has no minimum: its second derivatives are not positive definite"};
  return {cholesky.solve(F.g), {}};
}

}  // namespace sim::residual
