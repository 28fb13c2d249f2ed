// Which tangent an iteration takes.
#pragma once

#include <algorithm>
#include <limits>

#include "sim/choices.h"

namespace sim {

// A tangent made definite leads to a minimum from anywhere, but slowly where stresses are high: it lacks their negative
// stiffness. There the exact one is tried. It is good where its step is whole, and where it is cut but lowers the
// potential further than the definite one did, which crept; else it is given up, for longer each time, though never for
// more than some dozens of iterations: it may be what leads out of hundreds. [after Longva et al. 2023: project on
// demand]
class Exactness {
 public:
  // pure: `fix` from start to end
  Exactness(Definiteness fix, bool pure) : fix_(fix), pure_(pure) {}
  Definiteness next() {
    exact_ = fix_ == Definiteness::none || (!pure_ && slow_ && wait_ == 0);
    if (wait_ > 0) --wait_;
    return exact_ ? Definiteness::none : fix_;
  }
  bool exact() const { return exact_ && fix_ != Definiteness::none; }
  // After an iteration. definite: the tangent asked for was; whole: so was its step; fall: of the potential, beyond its
  // round-off [J]; increment: the largest of a node.
  void look(bool definite, bool whole, double fall, double increment) {
    if (exact_) {
      slow_ = definite && (whole || (creeps_ && fall > fall_));
      wait_ = slow_ ? 0 : pause_;
      pause_ = slow_ ? shortest : std::min(2 * pause_, longest);
    } else {
      slow_ = whole && increment > slow * last_;
      creeps_ = increment > creeping * last_;
      fall_ = fall;
    }
    last_ = increment;
  }

 private:
  // Shares of the increment that an iteration leaves, above which it is slow, and creeps.
  static constexpr double slow = 0.3, creeping = 0.8;
  static constexpr int shortest = 2, longest = 64;  // iterations without the exact tangent
  Definiteness fix_;
  bool pure_;
  bool exact_ = false;
  bool slow_ = false;    // the exact tangent is worth a try, or another
  bool creeps_ = false;  // the latest iteration with the definite tangent
  double fall_ = 0;      // of that one, J
  int wait_ = 0, pause_ = shortest;
  double last_ = std::numeric_limits<double>::infinity();
};

}  // namespace sim
