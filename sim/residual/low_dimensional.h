// A x = b in a few vectors, x = U c: the tall system A U c = b has no solution, and these are ways to choose one.
#pragma once

#include <vector>

#include "sim/residual/chain.h"

namespace sim::residual {

// a. As many rows as vectors: those equally spaced, the first, or the ones that QR with pivoting of (A U)^T takes
// first. Rows count from 0, ascending.
std::vector<int> equal_rows(int N, int n);
std::vector<int> first_rows(int n);
std::vector<int> pivoted_rows(const Eigen::MatrixXd& AU);
Eigen::VectorXd solve_rows(const Chain& chain, const Eigen::MatrixXd& U, const std::vector<int>& rows);

// b. min |A U c - b|^2
Eigen::VectorXd solve_least_squares(const Chain& chain, const Eigen::MatrixXd& U);

// c. U^T A U c = U^T b
Eigen::VectorXd solve_galerkin(const Chain& chain, const Eigen::MatrixXd& U);

// d. min of the springs' energy less the work of b, sum k_i stretch_i^2/2 - b.x over x = U c. The wind has no energy
// and is not seen. A is not formed, so that the agreement with c proves something.
Eigen::VectorXd solve_energy(const Chain& chain, const Eigen::MatrixXd& U);

// The x = U c nearest to the solution: what the vectors could do at best, and no method can know.
Eigen::VectorXd project(const Eigen::VectorXd& x, const Eigen::MatrixXd& U);

// A x = b itself
Eigen::VectorXd solve(const Chain& chain);

struct ChainErrors {
  double residual = 0;  // |A U c - b|
  double energy = 0;    // sqrt(e.A e), e = U c - x
  double distance = 0;  // |e|
  double largest = 0;   // max |e_i|
};
ChainErrors measure(const Chain& chain, const Eigen::VectorXd& x, const Eigen::VectorXd& approximation);

}  // namespace sim::residual
