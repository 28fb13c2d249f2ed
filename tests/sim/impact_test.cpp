// Bodies that are hit faster than waves run through them, and steps that are given up.
#include "sim/build/parts.h"
#include "sim/stepper.h"
#include "sim/term/contact.h"
#include "tests/sim/obstacle_support.h"

namespace sim {
namespace {

// A plate whose lower face is pinned flies at a soft box.
Scene swatted(double speed, double young) {
  Scene scene;
  scene.world.gravity = {0, 0, 0};
  scene.bodies = {test::box_body("plate", {1, 0.2, 1}, 2, {-0.5, 0, -0.5}, 1e7),
                  test::box_body("soft", {0.3, 0.3, 0.3}, 3, {-0.1, 0.5, -0.2}, young)};
  rotate(scene.bodies[1].mesh, {1, 2, 3}, 30);
  Pin pin{InGroup{"bottom"}, "xyz", {}, {}};
  pin.motion = {Keyframe{}, Keyframe{}};
  pin.motion[1].t = 1;
  pin.motion[1].translate = {0, speed, 0};
  scene.bodies[0].pins = {pin};
  scene.contacts = {Contact{}};
  return scene;
}

double stiffness_of(const Scene& scene) {
  const System system(scene);
  return parts_of(system).model.contacts.at(0)->input().couples.at(0).kappa;
}

TEST(Impact, StiffnessIsOfTheBodyOrOfTheImpact) {
  EXPECT_DOUBLE_EQ(stiffness_of(swatted(1, 1e5)), 1e4);         // 0.1 E
  EXPECT_DOUBLE_EQ(stiffness_of(swatted(30, 1e3)), 100 * 900);  // 0.1 rho v^2
  Scene thrown = swatted(1, 1e3);
  thrown.bodies[1].velocity = {0, -29, 0};
  EXPECT_DOUBLE_EQ(stiffness_of(thrown), 100 * 900);
  // The tip of what turns about an axis of its own, though only its middle is pinned: half a diagonal times the rate.
  Scene turned = swatted(1, 1e3);
  turned.bodies[0].pins[0].motion[1] = Keyframe{};
  turned.bodies[0].pins[0].motion[1].t = 1;
  turned.bodies[0].pins[0].motion[1].axis = {0, 1, 0};
  turned.bodies[0].pins[0].motion[1].degrees = 1800;
  EXPECT_NEAR(stiffness_of(turned), 100 * std::pow(10 * 3.14159265358979 * std::sqrt(0.5), 2), 1);
  turned.time.integrator = "static";
  EXPECT_DOUBLE_EQ(stiffness_of(turned), 100);
}

TEST(Impact, ASoftBodyIsSwattedAtAnyStep) {
  for (const int fps : {30, 100, 300}) {
    Scene scene = swatted(30, 1e3);
    scene.time.fps = fps;
    test::Stepped run(scene);
    for (int k = 0; k < fps / 10; ++k) {
      run.steps(1);
      // Of each other: nothing keeps a body out of itself here.
      ASSERT_EQ(test::count_crossings(scene, run.state.x, false), 0) << "step " << run.state.step;
    }
    EXPECT_GT(run.system.measure(run.state).p.y(), 0.5 * 27 * 30);  // it flies with the plate, or ahead of it
  }
}

TEST(Impact, AStepIsGivenUpWhenAsked) {
  const Scene scene = swatted(30, 1e3);
  const System system(scene);
  int asked = 0;
  const auto stepper = make_stepper(system, 1, [&] { return ++asked > 20; });
  State state = system.initial_state();
  StepReport report;
  State before;
  do {
    before = state;
    report = stepper->step(state);
  } while (report.failure.empty());
  EXPECT_TRUE(report.interrupted);
  EXPECT_EQ(asked, 21);
  EXPECT_TRUE(state.x == before.x && state.step == before.step);
}

TEST(Impact, ADistanceThatReachesOverTheGapIsRemarked) {
  Scene scene = swatted(1, 1e5);
  scene.bodies[1] = test::box_body("soft", {0.3, 0.3, 0.3}, 3, {-0.1, 0.25, -0.2});  // 0.05 m over the plate
  scene.contacts[0].distance = 0.2;
  const System system(scene);
  int told = 0;
  for (const std::string& remark : system.remarks())
    told += remark.starts_with("contact.0.distance: \"plate\" and \"soft\" start ");
  EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace sim
