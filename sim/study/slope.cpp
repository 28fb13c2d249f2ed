#include "sim/study/slope.h"

#include <cmath>

namespace sim {

// slope = sum (u - mean u)(w - mean w) / sum (u - mean u)^2,  u = log h, w = log e
double log_slope(std::span<const double> steps, std::span<const double> errors) {
  const auto n = static_cast<double>(steps.size());
  double u_mean = 0, w_mean = 0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    u_mean += std::log(steps[k]) / n;
    w_mean += std::log(errors[k]) / n;
  }
  double uw = 0, uu = 0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double u = std::log(steps[k]) - u_mean;
    uw += u * (std::log(errors[k]) - w_mean);
    uu += u * u;
  }
  return uw / uu;
}

}  // namespace sim
