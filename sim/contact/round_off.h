// What round-off may hide of where surfaces are.
#pragma once

#include "sim/math/vec3.h"

namespace sim {

// A place that is nearer to a plane than this may be on either side of it: what lies in one plane does not cross, and
// what is nearer than this touches. m, 1e-10 of the largest coordinate; x: positions of points.
inline double round_off_gap(const Eigen::Matrix3Xd& x) {
  return x.size() == 0 ? 0 : 1e-10 * x.cwiseAbs().maxCoeff();
}

}  // namespace sim
