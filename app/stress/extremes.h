// The extremes, group by group; each is a change to a scene.
#pragma once

#include "app/stress/case.h"

namespace app {

std::vector<Extreme> start_extremes();
std::vector<Extreme> untangle_extremes();
std::vector<Extreme> step_extremes();
std::vector<Extreme> material_extremes();
std::vector<Extreme> mesh_extremes();
std::vector<Extreme> script_extremes();

// Every node of every body anywhere in the rest box: what the extremes of step and material have to deal with.
void scramble(sim::Scene& scene);
// The longest h <= step [s] that the scene's clock can count: 1/n, or whole seconds.
void set_step(sim::Scene& scene, double step);

}  // namespace app
