// The way of the sample points through time, frame by frame, and what was measured on it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/study/sample.h"

namespace sim {

struct Trajectory {
  int dimension = 3;               // numbers per point
  std::vector<double> t;           // s, increasing
  std::vector<Eigen::VectorXd> x;  // m: dimension numbers per point, at each time
  std::vector<Measures> measures;  // energies and momenta at each time

  int frames() const { return static_cast<int>(t.size()); }
};

void add_frame(const System& system, const State& state, const Sampler& sampler, Trajectory& path);

}  // namespace sim
