// The scenes of assets/scenes/benchmarks end where their references say.
#include <gtest/gtest.h>

#include "app/scene/simulation.h"

namespace app {
namespace {

// Largest relative error of the components that have a reference.
double worst_error(const char* name) {
  Options options;
  options.scene = std::filesystem::path(RITZ_SOURCE_DIR) / "assets/scenes/benchmarks" / name;
  const Simulation simulation = build_simulation(options);
  sim::State state = simulation.system->initial_state();
  const auto stepper = sim::make_stepper(*simulation.system, 2);
  while (state.step < simulation.last_step()) {
    const sim::StepReport report = stepper->step(state);
    EXPECT_EQ(report.failure, "") << name;
    EXPECT_TRUE(report.converged) << name;
    if (!report.failure.empty()) return 1;
  }
  double worst = 0;
  int compared = 0;
  for (std::size_t k = 0; k < simulation.document.references.size(); ++k) {
    const Vec3 is = simulation.system->probe_displacement(state, static_cast<int>(k));
    const Vec3 should = simulation.document.references[k].value_or(Vec3::Zero());
    for (int c = 0; c < 3; ++c)
      if (should[c] != 0) {
        worst = std::max(worst, std::abs(is[c] / should[c] - 1));
        ++compared;
      }
  }
  EXPECT_GT(compared, 0) << name;
  return worst;
}

TEST(BenchmarkScenes, EndWhereTheirReferencesSay) {
  EXPECT_LT(worst_error("csm1.toml"), 0.001);
  EXPECT_LT(worst_error("cook.toml"), 0.001);
  EXPECT_LT(worst_error("beam-static.toml"), 0.002);
  EXPECT_LT(worst_error("elastica.toml"), 0.002);
}

// Friction has kinks. Where a step over one raised the energy by less than what round-off may hide, Newton's method
// went to and fro between two places until solver.max_iterations.
TEST(BenchmarkScenes, FrictionEvaluatedAnewTakesTensOfIterations) {
  Options options;
  options.scene = std::filesystem::path(RITZ_SOURCE_DIR) / "assets/scenes/arch.toml";
  options.overrides = {{"time.integrator", "tr-bdf2", ""},
                       {"time.substeps", "4", ""},
                       {"solver.tolerance", "1e-4", ""},
                       {"solver.lag_iterations", "1", ""}};
  const Simulation simulation = build_simulation(options);
  sim::State state = simulation.system->initial_state();
  const auto stepper = sim::make_stepper(*simulation.system, 1);
  while (state.step < 12) {
    const sim::StepReport report = stepper->step(state);
    EXPECT_TRUE(report.converged) << state.step << ": " << report.reason;
    EXPECT_LT(report.newton, 100) << state.step;
  }
}

}  // namespace
}  // namespace app
