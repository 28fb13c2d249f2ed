// The two surfaces that are nearest each other, of all that may touch.
#pragma once

#include <limits>
#include <string>

namespace sim {

struct Nearness {
  std::string first, second;                               // a body; a body or an obstacle
  double gap = 0;                                          // m
  double share = std::numeric_limits<double>::infinity();  // of the distance at which they begin to push
};

}  // namespace sim
