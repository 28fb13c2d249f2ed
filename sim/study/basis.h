// The vectors of a basis, x = X + U c.
//   modes        K psi = omega^2 M psi, the slowest
//   derivatives  psi_1 ... psi_k, then Phi_11, Phi_12, ...:  K Phi_ij = -(dK/dx . psi_i) psi_j, how the mode j changes
//                where the body is bent along the mode i [Idelsohn & Cardona 1985; Barbic & James 2005]; as few modes
//                as make enough of them
//   snapshots    what carries most of the displacements of a run, in the mass norm: proper orthogonal decomposition
// In this order they are made orthonormal in the mass, U^T M U = 1, and the first `count` are kept.
#pragma once

#include "sim/scene.h"

namespace sim {

bool has_basis(const Scene& scene);

// The same scene, in which every body with a basis has its vectors, and its cubature where it asks for one; what is
// there already stays. Throws InputError: a body that nothing holds turns, which no x = X + U c can follow.
Scene with_bases_made(Scene scene, int threads = 1);

// Phi_ij of modes psi, for i <= j in the order 11, 12, ..., 22, ...: D numbers per node x pairs.
Eigen::MatrixXd modal_derivatives(const Scene& scene, std::size_t body, const Eigen::MatrixXd& psi);

}  // namespace sim
