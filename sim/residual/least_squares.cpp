#include <Eigen/QR>

#include "sim/residual/grid.h"
#include "sim/residual/linear_system.h"

namespace sim::residual {

// int r^2 = sum_p w_p r(x_p)^2 is the squared length of a long vector, and its minimum that of a tall system of a row
// for each point. By QR: the normal equations A^T A c = A^T b would square the condition.
Answer least_squares(const Problem& problem, const Basis& basis, int n) {
  const Grid grid = gauss_grid(problem, n);
  const Vector root = grid.weight.cwiseSqrt();
  const Matrix A = root.asDiagonal() * apply_to_basis(problem, basis, n, grid.x);
  const Eigen::ColPivHouseholderQR<Matrix> qr(A);
  if (qr.rank() < n) return {{}, "its equations are singular"};
  return {qr.solve(root.cwiseProduct(values(problem.f, grid.x))), {}};
}

}  // namespace sim::residual
