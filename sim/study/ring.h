// A vibration that is known at a few times.
#pragma once

#include <span>
#include <vector>

namespace sim {

// Its maxima after the start, each the top of the parabola through three neighbouring values. Values are evenly spaced
// in time.
std::vector<double> maxima(std::span<const double> values);

}  // namespace sim
