// Moves by which bodies turn. Newton's method moves each node along a line; what a stiff body is to do is to turn, and
// a turn by the angle w along lines stretches it by w^2/2, which its stiffness forbids: it got around in hundreds of
// short moves. So the turn that is in dx is taken out of it and made a rotation,
//   w = I^-1 sum m r x (dx - d),  r = x - c,  u = dx - d - w x r,  c and d: means of x and dx, I: moment of inertia
//   x + turned = c + d + R (r + u),  R: about w, by the angle atan |w|,
// which takes r to where a rotation comes nearest to r + w x r. It differs from dx by its square only, so that what is
// downhill along dx is so along this, where dx is short. [a retraction: Absil, Mahony, Sepulchre 2008]
#pragma once

#include <Eigen/Core>

#include "sim/solve/model.h"

namespace sim {

// Of every body that turns by more than `least` [radian], none of whose components is prescribed (free[i] = 0); others
// move by dx. False: there is none.
bool turn_along(const Model& model, const Eigen::VectorXd& free, double least, const Eigen::VectorXd& x,
                const Eigen::VectorXd& dx, Eigen::VectorXd& turned);

}  // namespace sim
