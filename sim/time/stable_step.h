// The largest stable step of the explicit schemes: h < 2/omega_max, omega_max^2 the largest eigenvalue of M^{-1} K.
#pragma once

#include "sim/solve/model.h"

namespace sim {

// At rest [s]; infinity for a system without stiffness. From power iterations of M^{-1} K [no matrix is formed],
// enlarged by what they may still lack.
double stable_step(const Model& model);

}  // namespace sim
