// Starts: every shape of the table, with its defaults.
#include "sim/body/start.h"

#include "app/stress/extremes.h"

namespace app {

void scramble(sim::Scene& scene) {
  for (sim::Body& body : scene.bodies) body.start.shape = "scrambled";
}

std::vector<Extreme> start_extremes() {
  std::vector<Extreme> all;
  for (const sim::StartShape& shape : sim::start_shapes()) {
    if (shape.name == "rest" || shape.given) continue;
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

// What would stay stuck, with the pull that undoes inversions and folds switched on.
std::vector<Extreme> untangle_extremes() {
  const auto pulled = [](const std::string& name, bool quick, const std::function<void(sim::Scene&)>& change) {
    return Extreme{"untangle", name, quick, false, [change](sim::Scene& scene) {
                     change(scene);
                     for (sim::Body& body : scene.bodies) body.untangle = 1;
                   }};
  };
  std::vector<Extreme> all = {pulled("scrambled", false, scramble),
                              pulled("scrambled, h = 1 s", true,
                                     [](sim::Scene& scene) {
                                       scramble(scene);
                                       set_step(scene, 1);
                                     }),
                              pulled("scrambled, E = 1e9 Pa", true, [](sim::Scene& scene) {
                                scramble(scene);
                                for (sim::Body& body : scene.bodies) body.materials.front().young = 1e9;
                              })};
  for (const char* name : {"line", "point", "mirrored", "stretched"})
    all.push_back(pulled(name, false, [name](sim::Scene& scene) {
      for (sim::Body& body : scene.bodies) body.start.shape = name;
    }));
  return all;
}

}  // namespace app
