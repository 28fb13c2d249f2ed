// Material points at which runs of the same bodies are compared, whatever their meshes.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/mesh/input_error.h"
#include "sim/system.h"

namespace sim {

// The nodes of one system, with their shares of the mass: n points.
struct SamplePoints {
  int dimension = 3;
  Eigen::MatrixXd X;      // m, at rest, dimension x n
  Eigen::VectorXd mass;   // kg, > 0: the diagonal of the mass matrix, scaled to the mass of the body
  Eigen::VectorXd size;   // m, of the body that the point belongs to
  std::vector<int> body;  // of each point
  // A point that lies in no element of a body of tets rides on the nearest, as its skin does: meshes that fill a
  // surface follow it in steps of their own size, so the nodes of one may lie outside another.
  bool ride_on_nearest = false;

  int count() const { return static_cast<int>(mass.size()); }
};

SamplePoints sample_points(const System& system);

// Reads the positions of sample points off the states of a system with the same bodies and, perhaps, other meshes.
class Sampler {
 public:
  // Throws InputError (key "body.N.mesh") when a point lies in no element of its body, and does not ride on one.
  Sampler(const System& system, const SamplePoints& points);

  // dimension numbers per point [m]
  Eigen::VectorXd positions(const State& state) const;

 private:
  // Point p is sum_k weight_[k] x_(node_[k]) over start_[p] <= k < start_[p + 1].
  int dimension_;
  std::vector<int> start_ = {0}, node_;
  std::vector<double> weight_;
};

}  // namespace sim
