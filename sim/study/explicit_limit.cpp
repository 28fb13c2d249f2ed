#include "sim/study/explicit_limit.h"

#include "sim/build/parts.h"

namespace sim {

double explicit_limit(const Scene& scene, const System& system, int threads) {
  if (!parts_of(system).scheme->is_static) return system.stable_step();
  Scene moving = scene;
  moving.time.integrator = "backward-euler";
  return System(moving, threads).stable_step();
}

}  // namespace sim
