#include "sim/build/barrier_scheme.h"

#include "sim/mesh/input_error.h"

namespace sim {

bool serves(const Scheme& scheme, const Scene& scene) {
  return scheme.heeds_barriers() || (scene.contacts.empty() && scene.obstacles.empty());
}

// What ends a step somewhere that no iteration has seen, or goes there without looking, ends behind a barrier, where
// its energy is infinite: however short the steps, such runs stop at the first touch.
void check_barrier_scheme(const Parts& parts, const Scene& scene) {
  const Scheme& scheme = *parts.scheme;
  if (serves(scheme, scene)) return;
  const std::string why = scheme.is_explicit() ? "explicit steps do not look what is in their way"
                          : scheme.extrapolate ? "its steps end beyond what the iteration has seen"
                                               : "its one iteration has no line search";
  throw InputError("time.integrator", "\"" + std::string(scheme.name) +
                                          "\" cannot keep bodies off each other and off obstacles: " + why +
                                          "; take backward-euler, bdf2, sdirk2, tr-bdf2 or trapezoidal");
}

}  // namespace sim
