// The elastic forces of the weak form beside the slope of the elastic energy: two ways to the same numbers.
#pragma once

#include <Eigen/Core>

#include "sim/system.h"

namespace sim {

struct ForceCheck {
  Eigen::VectorXd galerkin;  // N: f_a = -sum_e sum_q w P grad N_a
  Eigen::VectorXd ritz;      // N: -dU/dx by central differences
  double largest = 0;        // N, of the components of galerkin
  double difference = 0;     // N, largest of a component
};

// Of every elastic term of the system; `h` [m]: half the way between the two energies of a difference.
ForceCheck check_forces(const System& system, const State& state, double h = 1e-6);

// df = -K dx at the state in two ways: element by element without a matrix, and by the assembled matrix. The system
// must form one (an implicit integrator and a direct solver).
struct ProductCheck {
  Eigen::VectorXd by_elements, by_matrix;  // N
  double difference = 0;                   // N, largest of a component
};
ProductCheck check_product(const System& system, const State& state, const Eigen::VectorXd& dx);

}  // namespace sim
