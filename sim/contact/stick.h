// Friction of one touch: what it keeps from where it was frozen, and the potential of its slip.
//   slip = (I - n n^T) sum_i c_i v_i,  U_f = mu lambda f0(|slip|) g h  [Li et al. 2020]
#pragma once

#include "sim/contact/smooth_friction.h"
#include "sim/contact/touch_potential.h"

namespace sim {

struct Stick {
  // strength: mu lambda [N]
  Stick(const TouchPotential& at, double friction)
      : couple(at.touch.couple), count(at.distance.nodes), n(at.distance.n) {
    strength = friction * at.push();
    for (int i = 0; i < count; ++i) {
      point[i] = at.touch.point[at.touch.near[i]];
      c[i] = at.distance.c[i];
    }
  }

  int couple;
  std::array<int, 4> point = {-1, -1, -1, -1};
  int count;
  double c[4] = {};
  Vec3 n;
  double strength;
};

// C^T k, for a vector k at the closest points
inline PairVector spread(const Stick& stick, const Vec3& k) {
  PairVector all = PairVector::Zero();
  for (int i = 0; i < stick.count; ++i) all.segment<3>(3 * i) = stick.c[i] * k;
  return all;
}
// C^T K C
inline PairMatrix spread(const Stick& stick, const Eigen::Matrix3d& K) {
  PairMatrix all = PairMatrix::Zero();
  for (int i = 0; i < stick.count; ++i)
    for (int j = 0; j < stick.count; ++j) all.block<3, 3>(3 * i, 3 * j) = stick.c[i] * stick.c[j] * K;
  return all;
}

}  // namespace sim
