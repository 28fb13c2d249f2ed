// What a basis can represent of the motion of the full body, and what the body in it makes of that.
#pragma once

#include <optional>
#include <span>

#include "sim/scene.h"
#include "sim/system.h"

namespace sim {

// Displacements of all nodes of the system [m], D numbers per node x states, empty where they cannot be computed: of a
// scene at rest, and of one without its bases at rest, and in the first half of the first swing, to its far end.
Eigen::MatrixXd displacement_at_rest(Scene scene, int threads);
Eigen::MatrixXd rest_of_full(const Scene& scene, int threads);
Eigen::MatrixXd swing_of_full(const Scene& scene, int threads);

// The root mean square over the mass of displacements d, as a share of the body's size [mathematics.md 9].
double share_of_size(const System& system, const Eigen::VectorXd& d);

// In the mass norm, over all states: |u - U U^T M u| / |u|, of displacements of the nodes of a system that moves in a
// basis; none where nothing is displaced.
std::optional<double> projection_error(const System& reduced, const Eigen::MatrixXd& u);

// Against displacements u at these steps, shares of the body's size [mathematics.md 9]: as near as the basis can come,
// and what its run comes to. Root mean squares, and of the run the largest of a node.
struct Compared {
  double best = 0, made = 0, most = 0;
  std::string failure;  // why the run ended early
};
Compared compare(const System& reduced, std::span<const std::int64_t> steps, const Eigen::MatrixXd& u, int threads);

}  // namespace sim
