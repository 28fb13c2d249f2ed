// Friction of one touch: what it keeps from where it was frozen, and the potential of its slip.
//   slip = (I - n n^T) sum_i c_i v_i,  U_f = mu lambda f0(|slip|) g h  [Li et al. 2020]
#pragma once

#include <span>

#include "sim/contact/smooth_friction.h"
#include "sim/contact/spread.h"
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

  std::span<const double> shares() const { return {c, static_cast<std::size_t>(count)}; }
};

}  // namespace sim
