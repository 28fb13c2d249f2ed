// Newton's method on U(x) as the lecture has it: one treatment of the eigenvalues from start to end, and nothing that
// comes to its help. For a few unknowns: the matrix is dense.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/system.h"

namespace sim {

enum class Stationary { none, minimum, saddle, maximum };

struct NewtonPath {
  std::vector<Eigen::VectorXd> points;  // positions of the system, the start first
  std::vector<double> energy;           // J, at every point
  std::vector<double> shares;           // of the full step that were taken
  bool singular = false;                // K had an eigenvalue of zero after the fix: the path ends there
  Stationary end = Stationary::none;    // where U does not change, what it is: by the eigenvalues of the exact K
  Eigen::VectorXd end_eigenvalues;      // N/m, of the exact K, rising

  int iterations() const { return static_cast<int>(shares.size()); }
};

// Without a fix full steps are taken. With one, steps are halved until U(x + s dx) <= U(x) + 1e-4 s g.dx [Armijo]. Ends
// when max |dx| is below 1e-9 of the body's size, or after 50 iterations.
NewtonPath pure_newton(const System& system, const Eigen::VectorXd& start, Definiteness fix);

// U of all terms at rest [J].
double potential_energy(const System& system, const Eigen::VectorXd& x);

// A symmetric matrix whose negative eigenvalues are kept, set to zero or made positive.
Eigen::MatrixXd made_definite(const Eigen::MatrixXd& K, Definiteness fix);

}  // namespace sim
