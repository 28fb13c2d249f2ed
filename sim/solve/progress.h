// Whether an iteration still gets anywhere. A stiff, tangled mesh needs hundreds of iterations that all do; where the
// energy has kinks, thousands may follow that do not.
#pragma once

#include <algorithm>
#include <limits>

namespace sim {

class Progress {
 public:
  enum class Kind {
    made,
    none,       // for many iterations: neither a share of what the slope promises nor a shorter increment
    round_off,  // what the potential falls by is close to its round-off: nothing can lower it much further
  };

  // After an iteration. fall: of the potential, beyond its round-off `noise` [J]; promised: by the slope; increment:
  // the largest of a node.
  Kind look(double fall, double promised, double increment, double noise) {
    idle_ = fall > least_share * promised || increment < shorter * smallest_ ? 0 : idle_ + 1;
    smallest_ = std::min(smallest_, increment);
    fallen_ += fall + noise;
    if (idle_ == most_idle) return promised < mostly_noise * noise ? Kind::round_off : Kind::none;
    if (++since_mark_ < stretch) return Kind::made;
    const bool flat = fallen_ < stretch * mostly_noise * noise && smallest_ > mark_ / 2;
    since_mark_ = 0;
    fallen_ = 0;
    mark_ = smallest_;
    return flat ? Kind::round_off : Kind::made;
  }

 private:
  static constexpr int most_idle = 15;  // iterations
  static constexpr int stretch = 50;    // iterations, over which the fall is compared with round-off
  static constexpr double least_share = 1e-3, shorter = 0.99;
  static constexpr double mostly_noise = 20;  // falls of so many round-offs
  int idle_ = 0, since_mark_ = 0;
  double fallen_ = 0;                                          // J, since the mark
  double smallest_ = std::numeric_limits<double>::infinity();  // increment so far
  double mark_ = std::numeric_limits<double>::infinity();      // smallest increment at the mark
};

}  // namespace sim
