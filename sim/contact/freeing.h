// The shortest way on which a body leaves what it crosses or touches.
#pragma once

#include <optional>

#include "sim/contact/meeting.h"

namespace sim {

// A translation of part `mover` of the couple after which the two are apart by xi + dh, so that nothing pushes: the
// shortest of those along the axes, the line between the middles of the two, and the normals of faces where they lie in
// each other. None for a body and itself.
std::optional<Vec3> freeing_translation(const Surfaces& surfaces, const Couple& couple, int mover,
                                        const Eigen::Matrix3Xd& x);

}  // namespace sim
