#include "sim/residual/grid.h"
#include "sim/residual/linear_system.h"

namespace sim::residual {
namespace {

// A_ij = int u_i L u_j, as it stands; nothing makes it symmetric but L itself.
Matrix strong_form(const Problem& problem, const Basis& basis, int n, const Grid& grid, const Matrix& weighted) {
  return weighted.transpose() * apply_to_basis(problem, basis, n, grid.x);
}

// By parts, -int u_i (k u_j')' = int k u_i' u_j': one derivative each, and no boundary term, as u_i is 0 at the ends.
// A_ij = int k u_i' u_j' + u_i (a u_j' + q u_j)
Matrix weak_form(const Problem& problem, const Basis& basis, int n, const Grid& grid) {
  const Eigen::Index points = grid.x.size();
  Matrix value(points, n), slope(points, n);
  std::vector<Sample> u(n);
  for (Eigen::Index p = 0; p < points; ++p) {
    basis.sample(grid.x[p], u);
    for (int i = 0; i < n; ++i) {
      value(p, i) = u[i].value;
      slope(p, i) = u[i].slope;
    }
  }
  const auto weighted = [&](const Function& g) { return values(g, grid.x).cwiseProduct(grid.weight).eval(); };
  return slope.transpose() * weighted(problem.k).asDiagonal() * slope +
         value.transpose() * (weighted(problem.a).asDiagonal() * slope + weighted(problem.q).asDiagonal() * value);
}

}  // namespace

Answer galerkin(const Problem& problem, const Basis& basis, int n) {
  const Grid grid = gauss_grid(problem, n);
  Matrix weighted(grid.x.size(), n);  // w_p u_i(x_p)
  std::vector<Sample> u(n);
  for (Eigen::Index p = 0; p < grid.x.size(); ++p) {
    basis.sample(grid.x[p], u);
    for (int i = 0; i < n; ++i) weighted(p, i) = grid.weight[p] * u[i].value;
  }
  const Matrix A = basis.smooth ? strong_form(problem, basis, n, grid, weighted) : weak_form(problem, basis, n, grid);
  return solve_system(A, weighted.transpose() * values(problem.f, grid.x));
}

}  // namespace sim::residual
