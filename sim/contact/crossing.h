// Where surfaces cross each other: an edge of the one goes through a face of the other; in the plane, two edges cross.
#pragma once

#include "sim/contact/candidates.h"

namespace sim {

struct Crossing {
  int couple;
  Vec3 at;
};

// x: positions of the points. In a fixed order.
std::vector<Crossing> crossings(const Skin& skin, const std::vector<Couple>& couples, const BroadPhase& broad_phase,
                                const Eigen::Matrix3Xd& x);

}  // namespace sim
