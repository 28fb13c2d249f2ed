// Starts: every shape of the table, with its defaults.
#include "sim/start/start.h"

#include "app/stress/extremes.h"

namespace app {

void scramble(sim::Scene& scene) {
  for (sim::Body& body : scene.bodies) body.start.shape = "scrambled";
}

std::vector<Extreme> start_extremes() {
  std::vector<Extreme> all;
  for (const sim::StartShape& shape : sim::start_shapes()) {
    if (shape.name == "rest") continue;
    const std::string name(shape.name);
    all.push_back({"start", name, true, false, [name](sim::Scene& scene) {
                     for (sim::Body& body : scene.bodies) body.start.shape = name;
                   }});
    if (shape.perturbation == 0) continue;
    all.push_back({"start", name + " 1e-6", false, false, [name](sim::Scene& scene) {
                     for (sim::Body& body : scene.bodies) {
                       body.start.shape = name;
                       body.start.perturbation = 1e-6;
                     }
                   }});
  }
  return all;
}

}  // namespace app
