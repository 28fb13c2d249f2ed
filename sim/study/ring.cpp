#include "sim/study/ring.h"

namespace sim {

std::vector<double> maxima(std::span<const double> values) {
  std::vector<double> all;
  for (std::size_t k = 1; k + 1 < values.size(); ++k) {
    const double a = values[k - 1], b = values[k], c = values[k + 1];
    if (!(b > a && b >= c)) continue;
    // y(s) = b + (c - a)/2 s + (a - 2b + c)/2 s^2 at s = -1, 0, 1
    const double slope = (c - a) / 2, bend = a - 2 * b + c;
    all.push_back(b - slope * slope / (2 * bend));
  }
  return all;
}

}  // namespace sim
