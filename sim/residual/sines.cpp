#include <cmath>
#include <numbers>

#include "sim/residual/basis.h"

namespace sim::residual {

// By the angle sum, sin((i + 1) a) = sin(i a) cos a + cos(i a) sin a: two library calls for all i.
void sample_sines(Real x, std::span<Sample> all) {
  const Real pi = std::numbers::pi_v<Real>, s = std::sin(pi * x), c = std::cos(pi * x);
  Real sine = s, cosine = c;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Real w = static_cast<Real>(k + 1) * pi;
    all[k] = {sine, w * cosine, -w * w * sine};
    const Real next = sine * c + cosine * s;
    cosine = cosine * c - sine * s;
    sine = next;
  }
}

}  // namespace sim::residual
