// A large system that is easy to see: a chain of springs between two walls.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace sim::residual {

// N masses at s_i = i h, h = 1/(N + 1), between walls at 0 and 1; A x = b with
//   (A x)_i = (k_{i-1/2} (x_i - x_{i-1}) - k_{i+1/2} (x_{i+1} - x_i))/h^2 + wind (x_{i+1} - x_{i-1})/(2h).
// A is symmetric positive definite where wind = 0: the springs' energy is x.A x/2.
struct Chain {
  Eigen::VectorXd springs;  // k_{i+1/2}/h^2, N + 1 of them
  double wind = 0;
  Eigen::VectorXd b;

  Eigen::Index size() const { return b.size(); }
  double spacing() const { return 1 / static_cast<double>(size() + 1); }
  Eigen::VectorXd places() const;  // s_i
};

Chain make_chain(int N, const std::function<double(double)>& stiffness, const std::function<double(double)>& load,
                 double wind);

Eigen::MatrixXd matrix(const Chain& chain);

// Stretch of every spring, x_i - x_{i-1} with x = 0 at the walls, for every column of x.
Eigen::MatrixXd stretches(const Eigen::MatrixXd& x);

// Columns s^j (1 - s), or sin(j pi s), j = 1 ... n.
Eigen::MatrixXd power_vectors(const Chain& chain, int n);
Eigen::MatrixXd sine_vectors(const Chain& chain, int n);

}  // namespace sim::residual
