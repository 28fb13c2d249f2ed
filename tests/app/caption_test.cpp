#include "app/picture/caption.h"

#include <gtest/gtest.h>

#include "app/scene/caption_names.h"
#include "sim/mesh/generate.h"

namespace app {
namespace {

TEST(Caption, NamesStandForLiveValues) {
  sim::Scene scene;
  scene.time.fps = 20;
  scene.time.substeps = 2;
  scene.bodies.resize(1);
  scene.bodies[0].mesh = sim::generate_box({1, 1, 1}, {1, 1, 1}, {1, 1, 1}, sim::ElementKind::tet4);
  scene.bodies[0].materials = {sim::MaterialSpec{}};
  const sim::System system(scene);
  Moment moment{15, 4, system.initial_state()};
  moment.state.step = 30;
  moment.state.v.setZero();
  for (Eigen::Index i = 0; i < moment.state.v.size(); i += 3) moment.state.v[i] = 3;
  EXPECT_EQ(caption("t = {t} s, frame {frame}", system, moment), "t = 0.75 s, frame 15");
  EXPECT_EQ(caption("h = {step}, {iterations} iterations", system, moment), "h = 0.025, 4 iterations");
  EXPECT_EQ(caption("{energy}", system, moment), "4500");  // 1000 kg at 3 m/s; gravity counts from rest
  moment.min_J = 0.25;
  EXPECT_EQ(caption("{steps} {kinetic} {elastic} {potential} {min_J}", system, moment), "30 4500 0 0 0.250");
  EXPECT_EQ(caption("{nodes} nodes, {elements} elements", system, moment), "8 nodes, 6 elements");
  EXPECT_EQ(caption("{nothing} {open", system, moment), "{nothing} {open");
  EXPECT_EQ(caption("", system, moment), "");
}

TEST(Caption, NamesOfATextAreFound) {
  EXPECT_EQ(caption_names("t = {t}, {nothing} {open"), (std::vector<std::string>{"t", "nothing"}));
  EXPECT_TRUE(caption_names("").empty());
}

}  // namespace
}  // namespace app
