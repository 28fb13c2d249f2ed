// Small scenes on which users stopped, each with its right value.
#include <gtest/gtest.h>

#include "app/picture/picture.h"
#include "app/scene/simulation.h"
#include "render/imgui_setup.h"
#include "render/letters.h"
#include "render/view.h"
#include "sim/stepper.h"
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
  EXPECT_EQ(remarks_with(all, "nothing is left to move"), 1);
}

TEST(Cases, NodesThatCoincideAreCountedAndJoinedOnDemand) {
  EXPECT_EQ(remarks_with(case_of("coincident-nodes"), "3 nodes stand where others do, and the body is in 2 parts"), 1);
  const Simulation joined = case_of("coincident-nodes", {case_setting("body.0.mesh.merge", "true")});
  EXPECT_EQ(remarks_with(joined, "3 nodes joined with others; the body is in 1 parts"), 1);
  expect_end(joined, {0.002915, -0.006694, 0.002915}, 1e-6);
}

TEST(Cases, ABlockThatStandsOnTheFloorStaysThere) {
  const Simulation simulation = case_of("touching-floor");
  sim::State state = simulation.system->initial_state();
  const auto stepper = sim::make_stepper(*simulation.system, 1);
  for (std::int64_t step = 0; step < simulation.last_step(); ++step) ASSERT_EQ(stepper->step(state).failure, "");
  const sim::BodyRange& body = simulation.system->bodies()[0];
  EXPECT_LT((state.x - body.mesh->X.reshaped()).cwiseAbs().maxCoeff(), 0.012);  // it sags under its weight
  EXPECT_NE(error_of([] {
              case_of("touching-floor", {case_setting("body.0.mesh.translate", "[0, -0.2, 0]")});
            }).find("starts 0.2 m inside this obstacle: translate it by (0, 0.2, 0)"),
            std::string::npos);
}

TEST(Cases, StaticsOfWhatNothingHoldsFails) {
  const Simulation simulation = case_of("nothing-holds");
  sim::State state = simulation.system->initial_state();
  EXPECT_NE(sim::make_stepper(*simulation.system, 1)->step(state).failure.find("6 motions of a rigid body are free"),
            std::string::npos);
}

TEST(Cases, ElementsThatLockAreTold) {
  EXPECT_EQ(remarks_with(case_of("quad4-locks"), "locking: \"beam\" has linear elements (quad4)"), 1);
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

render::Frame first_frame(const Simulation& simulation) {
  const Picture picture(*simulation.system, simulation.document, 320, 180);
  return picture.frame({.state = simulation.system->initial_state()});
}

// Every vertex of bodies and both ends of the ball are in the picture, at every fifth frame, and no floor hides them.
TEST(Cases, BlockAndBallAreSeenAtAllTimes) {
  const Simulation simulation = case_of("floor-hides-ball");
  const Picture picture(*simulation.system, simulation.document, 320, 180);
  sim::State state = simulation.system->initial_state();
  const auto stepper = sim::make_stepper(*simulation.system, 1);
  for (std::int64_t step = 0; step <= simulation.last_step(); ++step) {
    const render::Frame frame = picture.frame({.state = state});
    EXPECT_FALSE(frame.ground);
    const render::View view = render::make_view(frame.camera, 320.0F / 180, render::bounds_of(frame));
    const auto is_seen = [&](const Eigen::Vector3f& point) {
      const Eigen::Vector3f at = view.to_window(point, 320, 180);
      return at.x() > 0 && at.x() < 320 && at.y() > 0 && at.y() < 180;
    };
    for (std::size_t i = 0; i < frame.surfaces[0].positions.size(); i += 3)
      ASSERT_TRUE(is_seen(Eigen::Map<const Eigen::Vector3f>(frame.surfaces[0].positions.data() + i))) << step;
    EXPECT_TRUE(is_seen({-0.5F, 0.5F, 0}) && is_seen({0.5F, 0.5F, 0}) && is_seen({0, 0, 0})) << step;
    stepper->step(state);
  }
}

TEST(Cases, AtMapCoordinatesThePictureIsTheSame) {
  const Simulation far = case_of("map-coordinates");
  const Simulation near = case_of(
      "map-coordinates", {case_setting("body.0.mesh.translate", "[0, 0]"), case_setting("probe.0.at", "[4, 0.5]")});
  const render::Frame a = first_frame(far), b = first_frame(near);
  ASSERT_EQ(a.surfaces[0].positions.size(), b.surfaces[0].positions.size());
  const float x = a.surfaces[0].positions[0] - b.surfaces[0].positions[0];
  const float y = a.surfaces[0].positions[1] - b.surfaces[0].positions[1];
  for (std::size_t i = 0; i < a.surfaces[0].positions.size(); i += 3) {
    EXPECT_NEAR(a.surfaces[0].positions[i] - b.surfaces[0].positions[i], x, 1e-5);
    EXPECT_NEAR(a.surfaces[0].positions[i + 1] - b.surfaces[0].positions[i + 1], y, 1e-5);
  }
  EXPECT_NEAR(a.camera.target[0] - b.camera.target[0], x, 1e-5);
  EXPECT_EQ(a.camera.height, b.camera.height);
  EXPECT_EQ(a.origin[0] + x, 408201);
  EXPECT_EQ(a.origin[1] + y, 4080928);
}

TEST(Cases, TheFontHasTheLettersOfTheTitle) {
  if (!render::has_dejavu()) GTEST_SKIP() << "fonts-dejavu-core is not installed";
  EXPECT_EQ(render::letters_that_lack(case_of("letters").document.title), "");
}

}  // namespace
}  // namespace app
