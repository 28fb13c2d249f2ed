// The two constants of linear elasticity that every material here is made of.
#pragma once

namespace sim {

struct Lame {
  double mu = 0, lambda = 0;  // Pa
};

// mu = E/(2(1+nu)), lambda = E nu/((1+nu)(1-2nu)); membranes are in plane stress: lambda = E nu/(1-nu^2).
inline Lame lame(double E, double nu, bool plane_stress) {
  const double mu = E / (2 * (1 + nu));
  return {mu, plane_stress ? E * nu / (1 - nu * nu) : E * nu / ((1 + nu) * (1 - 2 * nu))};
}

}  // namespace sim
