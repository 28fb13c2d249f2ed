// Where a script puts what it moves.
//   x(t) = c + R(theta) (X - c) + translate
#pragma once

#include <vector>

#include "sim/scene.h"

namespace sim {

class Pose {
 public:
  // Linear between keyframes, constant outside; at a keyframe the rate is that of the piece before it.
  Pose(const std::vector<Keyframe>& motion, double t);

  // Of what is at X without the script [m].
  Vec3 place(const Vec3& X) const;
  // A direction, turned.
  Vec3 turned(const Vec3& direction) const;
  // Of what the script moves and is at x now [m/s].
  Vec3 velocity(const Vec3& x) const;
  bool moves() const { return turn_rate_ != 0 || !translate_rate_.isZero(0); }

 private:
  Keyframe at_;
  Vec3 translate_rate_ = {0, 0, 0};  // m/s
  double turn_rate_ = 0;             // rad/s
};

}  // namespace sim
