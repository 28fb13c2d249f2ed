// Forces between round bodies that are pressed together: for the tests of contact.
#pragma once

#include <cmath>
#include <numbers>

namespace sim::test {

constexpr double ball_radius = 0.5, ball_poisson = 0.3, ball_young = 1e6,
                 ball_star = ball_young / (1 - ball_poisson * ball_poisson);

// Of a sphere on a plane, for bodies that go on for ever: F = 4/3 E* sqrt(R) d^1.5 [Hertz 1882]
inline double hertz(double approach) {
  return 4.0 / 3 * ball_star * std::sqrt(ball_radius) * std::pow(approach, 1.5);
}

// A sphere between two plates, which the half of one with a plane middle is, gives way a little less: by F f/(pi E) for
// each plate, with f of the radius a of the area that touches: hertz(d + F f/(pi E)) = F. [Tatara 1991]
inline double two_plates(double approach) {
  double F = hertz(approach);
  for (int k = 0; k < 50; ++k) {
    const double a = std::cbrt(0.75 * F * ball_radius / ball_star), r2 = a * a + 4 * ball_radius * ball_radius;
    const double f = 2 * (1 + ball_poisson) * ball_radius * ball_radius / std::pow(r2, 1.5) +
                     (1 - ball_poisson * ball_poisson) / std::sqrt(r2);
    F = hertz(approach + F * f / (std::numbers::pi * ball_young));
  }
  return F;
}

}  // namespace sim::test
