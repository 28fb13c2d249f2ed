// What one touch adds to the potential, weight M b(d), and its derivatives.
#pragma once

#include "sim/contact/barrier.h"
#include "sim/contact/distance.h"
#include "sim/contact/touch.h"
#include "sim/material/tangent.h"

namespace sim {

// Points that a touch moves with.
inline int points_in(const Touch& touch) {
  return touch.e > 0 ? 4 : node_count(touch.feature);
}

// weight M b; x: positions of the skin's points
double touch_energy(const Touch& touch, const Couple& couple, const Eigen::Matrix3Xd& x);

struct TouchPotential {
  TouchPotential(const Touch& touch, const Couple& couple, const Eigen::Matrix3Xd& positions);

  // Three numbers for each of the touch's points.
  PairVector gradient() const;
  PairMatrix tangent(Definiteness fix) const;
  // The normal force -weight M b' [N].
  double push() const { return -touch.weight * M * b.first; }

  const Touch& touch;
  Vec3 x[4], near[4];  // of its points; of those that carry the distance
  Distance distance;
  Barrier b;
  double M = 1;
};

}  // namespace sim
