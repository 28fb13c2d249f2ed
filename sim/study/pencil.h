// Stiffness and mass of a body at rest, restricted to its free components: what vibration modes are made of.
#pragma once

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

}  // namespace sim
