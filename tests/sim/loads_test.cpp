#include "sim/study/loads.h"

#include <gtest/gtest.h>

#include "sim/mesh/generate.h"
#include "sim/stepper.h"

namespace sim {
namespace {

// A block of 2 m^3 that rests on its pinned bottom: what holds it is its weight and the load on its top.
TEST(Loads, APinnedBlockIsHeldAgainstWeightAndLoad) {
  Scene scene;
  scene.time.integrator = "static";
  scene.solver.tolerance = 1e-9;
  Body body;
  body.name = "block";
  body.mesh = generate_box({1, 2, 1}, {2, 4, 2}, {1, 1, 1}, ElementKind::tet4);
  body.materials = {MaterialSpec{"stable-neo-hookean", 1e6, 0.3, 1000, ""}};
  body.pins = {Pin{InGroup{"bottom"}, "xyz", {}, {}}};
  body.loads.tractions = {{.where = InGroup{"top"}, .value = {300, -500, 0}}};
  scene.bodies = {body};
  const System system(scene);
  State state = system.initial_state();
  const auto stepper = make_stepper(system, 1);
  ASSERT_TRUE(stepper->step(state).failure.empty());
  const Loads found = loads(system, state);
  Vec3 applied = Vec3::Zero(), held = Vec3::Zero();
  for (Eigen::Index i = 0; i < state.x.size(); i += 3) {
    applied += found.applied.segment<3>(i);
    held += found.held.segment<3>(i);
  }
  EXPECT_NEAR((applied - Vec3(300, -500, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR((held - Vec3(-300, 500 + 2 * 1000 * 9.81, 0)).norm(), 0, 1e-3);
}

}  // namespace
}  // namespace sim
