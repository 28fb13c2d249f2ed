// How far two trajectories of the same sample points are apart. [mathematics.md 9]
#pragma once

#include <Eigen/Core>

#include "sim/study/trajectory.h"

namespace sim {

//   e(t) = sqrt( sum_i m_i |x_i - y_i|^2 / size_i^2  /  sum_i m_i ),   rms = sqrt( mean over frames of e(t)^2 )
// Shares of the size of the body.
struct Difference {
  double rms = 0;
  double max = 0;          // largest |x_i - y_i| / size_i of any point in any frame
  Eigen::VectorXd frames;  // e(t)
};

// Over the frames that both have, the first `most` of them at most (negative: all). Infinite where a number is not
// finite.
Difference difference(const Trajectory& a, const Trajectory& b, const SamplePoints& points, int most = -1);

// The same of the centre of mass of all bodies, over the largest size.
double centre_difference(const Trajectory& a, const Trajectory& b, const SamplePoints& points, int most = -1);

// Largest change of energy and momentum against a reference: |E - E_ref| over the largest energy that the reference
// holds in motion and deformation, |p - p_ref| over the largest momentum that its kinetic energy could carry,
// sqrt(2 M T). For a closed system these are the drifts. The energy on average over the frames: mean.
struct Drift {
  double energy = 0, momentum = 0;
  double mean_energy = 0;
};
Drift drift(const Trajectory& path, const Trajectory& reference, const SamplePoints& points, int most = -1);

}  // namespace sim
