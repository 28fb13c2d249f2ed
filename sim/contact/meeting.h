// How the surfaces of a pair lie to each other at a moment: apart, touching, or one in the other.
#pragma once

#include "sim/contact/candidates.h"

namespace sim {

enum class Meet { apart, touches, crosses };

struct Meeting {
  Meet how = Meet::apart;
  std::vector<Vec3> places;  // m: where; each told once
};

struct Surfaces {
  const Skin& skin;
  const BroadPhase& broad_phase;
  std::vector<bool> is_solid;  // of each part: a body that fills what its faces enclose
};

// Bodies cross where an edge of the one goes through a face of the other, and where a face of the one lies inside the
// other, as of blocks whose sides share their planes: no edge tells of those. They touch where they are no further
// apart than the offset, or than `more` beyond it, or than what round-off may hide. x: positions of the points.
Meeting meeting(const Surfaces& surfaces, const Couple& couple, const Eigen::Matrix3Xd& x, double more = 0);

// Positions of the points of a skin when the nodes of the system are at x.
Eigen::Matrix3Xd points_at(const Skin& skin, const Eigen::VectorXd& x);

}  // namespace sim
