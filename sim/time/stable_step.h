// The largest stable step of the explicit schemes.
#pragma once

#include "sim/solve/model.h"

namespace sim {

// By how much the eigenvalues that power iterations have reached are enlarged, for what they still lack.
inline constexpr double lacking = 1.05;

// Of a vibration x'' = -omega^2 x - d x', whose damping is taken at the velocity before the kick: h^2 omega^2 + 2 h d <
// 4,
//   h < (sqrt(d^2 + 4 omega^2) - d) / omega^2,
// which is 2/omega without damping. omega2 [1/s^2], d [1/s]; infinity without stiffness and damping.
double stable_step(double omega2, double d);

// Of the fastest vibration at rest [s], omega^2 the largest eigenvalue of M^{-1} K: from power iterations [no matrix is
// formed].
double stable_step(const Model& model);

}  // namespace sim
