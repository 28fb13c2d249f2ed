// How fast an integrator's step lets motion grow: from noise, at a step that is near the limit or far beyond it.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "sim/scene.h"

namespace sim {

struct Growth {
  std::vector<double> reach;       // largest displacement [m] after every step, 0 before the first
  std::vector<Eigen::VectorXd> x;  // positions [m] at the same times

  // Mean growth per step: of motion beyond the limit, while the fastest mode is alone and the motion still small; of
  // motion that stays small, from the largest of the first half to the largest of the second.
  double per_step() const;
};

// Of the scene's bodies at rest, gravity left out, which start with velocities of random sign that move them 1e-12 of
// their size in a step. Ends early where positions are not finite.
Growth growth(const Scene& scene, const std::string& integrator, double h, int steps);

// Of the highest mode in a step of the leap-frog at h = x 2/omega: (x + sqrt(x^2 - 1))^2 beyond the limit x = 1,
// else 1.
double growth_per_step(double x);

}  // namespace sim
