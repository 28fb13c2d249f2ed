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
std::vector<Extreme> obstacle_extremes();
std::vector<Extreme> contact_extremes();
std::vector<Extreme> bending_extremes();

// Low and high end of the first body along its longest axis, and its middle; across: where it is thinnest, but not
// flat.
struct Ends {
  sim::Box low, high;
  sim::Vec3 along, across, middle;
  double length, thickness;  // m
};
Ends ends_of(const sim::Scene& scene);

// Every node of every body anywhere in the rest box: what the extremes of step and material have to deal with.
void scramble(sim::Scene& scene);
// The longest h <= step [s] that the scene's clock can count: 1/n, or whole seconds.
void set_step(sim::Scene& scene, double step);

}  // namespace app
