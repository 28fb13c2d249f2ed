// Stiffness and mass of a body at rest, restricted to its free components: what vibration modes are made of.
#pragma once

#include <vector>

#include "sim/linear/cholesky.h"
#include "sim/linear/sparse.h"
#include "sim/scene.h"
#include "sim/system.h"

namespace sim {

// The body with this number alone, at rest, under nothing but its pins.
Scene at_rest_alone(const Scene& scene, std::size_t number);

struct Pencil {
  Eigen::VectorXd free;  // 1 where a component is free, else 0
  SparseMatrix K, M;     // of the free components

  // The system is of one body, at_rest_alone.
  explicit Pencil(const System& system);
  Eigen::Index size() const { return K.rows(); }
};

// A factor of K + shift M by CHOLMOD.
class PencilFactor {
 public:
  // The system that the pencil is of must outlive this. Throws InputError (key "mesh") where there is no memory for it,
  // or where K + shift M is not positive definite.
  PencilFactor(const System& system, double shift);
  // x = (K + shift M)^{-1} b, of the free components.
  void solve(const double* b, double* x);
  Eigen::Index size() const { return static_cast<Eigen::Index>(free_.size()); }

 private:
  std::vector<Eigen::Index> free_;  // the components that are
  Cholesky cholesky_;
  Eigen::VectorXd b_, x_;  // of all components
};

}  // namespace sim
