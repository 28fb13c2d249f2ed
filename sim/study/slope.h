// The order that a series of errors shows.
#pragma once

#include <span>

namespace sim {

// Least-squares slope of log(error) over log(step): e = C h^slope. Both > 0, two entries or more, not all steps equal.
double log_slope(std::span<const double> steps, std::span<const double> errors);

}  // namespace sim
