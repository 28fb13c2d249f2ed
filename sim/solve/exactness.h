// Which tangent an iteration takes.
#pragma once

#include <limits>

#include "sim/choices.h"

namespace sim {

// A tangent made definite leads to a minimum from anywhere, but slowly where stresses are
// high: it lacks their negative stiffness. There the exact one is tried, and given up for ever longer
// where it is not definite or its steps are cut. [Longva et al. 2023: project on demand]
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
  void look(bool good, double residual) {
    slow_ = good && residual > slow * last_;
    if (exact_ && !good) {
      wait_ = pause_;
      pause_ *= 2;
    }
    last_ = residual;
  }

 private:
  static constexpr double slow = 0.3;  // an iteration that leaves more than this of the residual
  Definiteness fix_;
  bool pure_;
  bool exact_ = false, slow_ = false;
  int wait_ = 0, pause_ = 2;
  double last_ = std::numeric_limits<double>::infinity();
};

}  // namespace sim
