// Steps: from a millionth of a second to two seconds, from a scrambled start.
#include <algorithm>
#include <cmath>

#include "app/stress/extremes.h"

namespace app {

void set_step(sim::Scene& scene, double step) {
  scene.time.unit = std::max(1, static_cast<int>(step));
  scene.time.fps = std::max(1, static_cast<int>(std::ceil(scene.time.unit / step * (1 - 1e-12))));
  scene.time.substeps = 1;
}

std::vector<Extreme> step_extremes() {
  struct Step {
    const char* name;
    double seconds;
    bool quick;
  };
  constexpr Step steps[] = {{"h = 1e-6 s", 1e-6, false},
                            {"h = 1e-4 s", 1e-4, false},
                            {"h = 1e-3 s", 1e-3, false},
                            {"h = 1/240 s", 1.0 / 240, false},
                            {"h = 1/60 s", 1.0 / 60, false},
                            {"h = 1/24 s", 1.0 / 24, false},
                            {"h = 0.1 s", 0.1, true},
                            {"h = 0.5 s", 0.5, false},
                            {"h = 1 s", 1, true},
                            {"h = 2 s", 2, false}};
  std::vector<Extreme> all;
  for (const Step& step : steps)
    all.push_back({"step", step.name, step.quick, false, [seconds = step.seconds](sim::Scene& scene) {
                     scramble(scene);
                     set_step(scene, seconds);
                   }});
  return all;
}

}  // namespace app
