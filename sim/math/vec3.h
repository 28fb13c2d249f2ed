// Three numbers; in a 2D scene the third is zero and means nothing.
#pragma once

#include <Eigen/Core>

namespace sim {

using Vec3 = Eigen::Vector3d;

}  // namespace sim
