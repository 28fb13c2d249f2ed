// Points that trade one cost against another.
#pragma once

#include <span>
#include <vector>

namespace sim {

struct WorkError {
  double work = 0;   // > 0
  double error = 0;  // > 0
};

// Those that no other beats in both, by increasing work; of equal ones the first.
std::vector<int> front(std::span<const WorkError> points);

// The knee of a front: the member farthest below the straight line between its ends, in logarithms scaled to the
// front's extent in both directions [Das 1999]. `members` as front() gives them, not empty.
int knee(std::span<const WorkError> points, std::span<const int> members);

}  // namespace sim
