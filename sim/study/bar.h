// The clamped bar as a check of frequencies: u'' waves of speed c = sqrt(E/rho) in linear elements of length h = L/n.
#pragma once

#include <Eigen/Core>

#include "sim/scene.h"

namespace sim {

// rad/s, mode k from 1: of the bar itself, and of n linear elements with consistent and with lumped mass.
struct BarFrequencies {
  double exact = 0, consistent = 0, lumped = 0;
};
BarFrequencies bar_frequencies(double L, double young, double density, int n, int k);

// The modes of a strip of quadrilaterals, one cell high, that are those of a bar: all of a cross-section moves alike.
// The first `count` of them; fewer where there are fewer. [rad/s] and shapes as in Modes.
struct BarModes {
  Eigen::VectorXd omega;
  Eigen::MatrixXd shape;
};
BarModes bar_modes(const Scene& scene, std::size_t body, int count);

}  // namespace sim
