#include "sim/residual/linear_system.h"
#include "sim/residual/rule.h"

namespace sim::residual {

Vector equal_points(int n) {
  return Vector::LinSpaced(n, 1, n) / Real(n + 1);
}

Vector gauss_points(int n) {
  return (gauss_legendre(n).t + Vector::Ones(n)) / 2;
}

Answer collocate(const Problem& problem, const Basis& basis, const Vector& points) {
  const int n = static_cast<int>(points.size());
  return solve_system(apply_to_basis(problem, basis, n, points), values(problem.f, points));
}

}  // namespace sim::residual
