// How fast an integrator's step lets motion grow: from noise, at a step that is near the limit or far beyond it.
#pragma once

#include <string>
#include <vector>

#include "sim/scene.h"

namespace sim {

// Largest displacement [m] after every step of the scene's bodies at rest, gravity left out, which start with
// velocities of random sign that move them 1e-12 of their size in a step. Ends early where positions are not finite.
std::vector<double> growth(const Scene& scene, const std::string& integrator, double h, int steps);

// Of the highest mode in a step of the leap-frog at h = x 2/omega: (x + sqrt(x^2 - 1))^2 beyond the limit x = 1,
// else 1.
double growth_per_step(double x);

}  // namespace sim
