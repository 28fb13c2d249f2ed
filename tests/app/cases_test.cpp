// Small scenes on which users stopped, each with its right value.
#include <gtest/gtest.h>

#include "app/scene/simulation.h"
#include "tests/app/mesh_data.h"

namespace app {
namespace {

Simulation case_of(const std::string& name, const std::vector<Override>& overrides = {}) {
  Options options;
  options.scene = data_folder() / "cases" / (name + ".toml");
  options.overrides = overrides;
  return build_simulation(options);
}

Override case_setting(const std::string& key, const std::string& value) {
  return {key, value, "--set " + key + "=" + value};
}

// Displacement of the first probe at the end; the last report tells of failures.
sim::Vec3 end_of(const Simulation& simulation, sim::StepReport& last) {
  sim::State state = simulation.system->initial_state();
  const auto stepper = sim::make_stepper(*simulation.system, 1);
  for (std::int64_t step = 0; step < simulation.last_step() && last.failure.empty(); ++step)
    last = stepper->step(state);
  return simulation.system->probe_displacement(state, 0);
}

void expect_end(const Simulation& simulation, const sim::Vec3& right, double error) {
  sim::StepReport last;
  const sim::Vec3 found = end_of(simulation, last);
  EXPECT_EQ(last.failure, "");
  EXPECT_LT((found - right).norm(), error) << found.transpose();
}

int remarks_with(const Simulation& simulation, const std::string& part) {
  int count = 0;
  for (const std::string& remark : simulation.remarks()) count += remark.find(part) != std::string::npos;
  return count;
}

TEST(Cases, AGroupNumberThatIsUsedTwiceIsToldByItsDimension) {
  EXPECT_NE(error_of([] { case_of("same-number-groups"); })
                .find("2 groups are called \"1\", of dimension 2 (3 nodes), 3 "
                      "(5 nodes): say which with dimension = 2"),
            std::string::npos);
  const Simulation triangle = case_of("same-number-groups", {case_setting("body.0.pin.0.dimension", "2")});
  EXPECT_EQ(triangle.system->counts().free_dofs, 6);
  expect_end(triangle, {0.0095426, -0.0191101, -0.0064597}, 1e-6);
  const Simulation all = case_of("same-number-groups", {case_setting("body.0.pin.0.dimension", "3")});
  EXPECT_EQ(all.system->counts().free_dofs, 0);
}

TEST(Cases, NodesThatCoincideAreCountedAndJoinedOnDemand) {
  EXPECT_EQ(remarks_with(case_of("coincident-nodes"), "3 nodes stand where others do, and the body is in 2 parts"), 1);
  const Simulation joined = case_of("coincident-nodes", {case_setting("body.0.mesh.merge", "true")});
  EXPECT_EQ(remarks_with(joined, "3 nodes joined with others; the body is in 1 parts"), 1);
  expect_end(joined, {0.002915, -0.006694, 0.002915}, 1e-6);
}

TEST(Cases, AFlatMeshCanBeAMembraneInSpace) {
  const Simulation simulation = case_of(
      "flat-in-space", {case_setting("body.0.mesh.space", "3"), case_setting("body.0.mesh.translate", "[0, 0, 1]"),
                        case_setting("probe.0.at", "[4, 0.5, 1]")});
  EXPECT_EQ(simulation.document.scene.dimension, 3);
  EXPECT_EQ(simulation.document.scene.bodies[0].mesh.X.row(2).minCoeff(), 1);
}

TEST(Cases, SurfacesOfPolygonsAndFlatFacesAreBodies) {
  EXPECT_EQ(case_of("polygons").system->counts().elements, 4);
  EXPECT_EQ(case_of("flat-triangle").system->counts().elements, 3);
  EXPECT_EQ(case_of("binary-element-data").system->counts().elements, 1);
  EXPECT_EQ(case_of("comments-first").system->counts().elements, 1);
}

}  // namespace
}  // namespace app
