// What is lost when a function is known at the nodes of a plane mesh only.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "sim/mesh/mesh.h"

namespace sim {

struct PlaneFunction {
  std::function<double(const Eigen::Vector2d& X)> value;
  std::function<Eigen::Vector2d(const Eigen::Vector2d& X)> gradient;
};

// Of e = I u - u, I u = sum_i u(X_i) N_i the interpolant.
struct InterpolationError {
  double L2 = 0;           // sqrt int e^2
  double H1_seminorm = 0;  // sqrt int |grad e|^2
  double max = 0;          // largest |e| at a lattice of 41 points along every edge of every element
};

// The mesh is plane. Integrals are exact to round-off where u is smooth over an element.
InterpolationError interpolation_error(const Mesh& mesh, const PlaneFunction& u);

}  // namespace sim
