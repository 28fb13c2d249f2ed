#include "sim/study/trajectory.h"

namespace sim {

void add_frame(const System& system, const State& state, const Sampler& sampler, Trajectory& path) {
  path.dimension = system.dimension();
  path.t.push_back(system.time(state.step));
  path.x.push_back(sampler.positions(state));
  path.measures.push_back(system.measure(state));
}

}  // namespace sim
