#include "sim/residual/linear_system.h"

#include <Eigen/LU>

namespace sim::residual {

Answer solve_system(const Matrix& A, const Vector& b) {
  constexpr Real round_off = 1e-17L;
  const Eigen::PartialPivLU<Matrix> lu(A);
  if (!(lu.rcond() > round_off)) return {{}, "its equations are singular"};
  return {lu.solve(b), {}};
}

Matrix apply_to_basis(const Problem& problem, const Basis& basis, int n, const Vector& points) {
  Matrix rows(points.size(), n);
  std::vector<Sample> u(n);
  for (Eigen::Index p = 0; p < points.size(); ++p) {
    basis.sample(points[p], u);
    const Jet k = problem.k(points[p]);
    const Real a = problem.a(points[p]).value, q = problem.q(points[p]).value;
    for (int i = 0; i < n; ++i) rows(p, i) = -k.value * u[i].curvature + (a - k.slope) * u[i].slope + q * u[i].value;
  }
  return rows;
}

Vector values(const Function& g, const Vector& points) {
  return points.unaryExpr([&](Real x) { return g(x).value; });
}

}  // namespace sim::residual
