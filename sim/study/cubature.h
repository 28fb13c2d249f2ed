// Few elements that stand for all of a body which moves in a basis: their forces, weighted, are those of all elements
// on its coordinates, as near as is asked for, at the states of a training. [An, Kim & James 2008; Farhat et al. 2015]
//   sum_e w_e U_e^T f_e(X + U c_s)  ~  U^T f(X + U c_s),   w >= 0
// States are those of a run where the basis has some. Otherwise the body swings once, in its basis and with all of its
// elements, under its own loads, and once along each axis under a weight that bends it by a tenth of its size.
#pragma once

#include "sim/scene.h"

namespace sim {

// Gives every body that asks for a cubature and has none yet its own.
void train_cubatures(Scene& scene, int threads);

// The reduced elastic forces of each of some elements, one column each, at states c (one a column): the states one
// below the other. `body`: of the scene, with vectors.
Eigen::MatrixXd element_forces(const Scene& scene, std::size_t body, const std::vector<int>& elements,
                               const Eigen::MatrixXd& c);

}  // namespace sim
