#include "app/picture/arrows.h"

#include <gtest/gtest.h>

#include "sim/mesh/generate.h"
#include "sim/study/loads.h"

namespace app {
namespace {

// A unit box, pinned below, pulled upwards by 200 Pa; no weight.
Document pulled_box(int cells) {
  Document document;
  document.scene.world.gravity.setZero();
  sim::Body body;
  body.name = "box";
  body.mesh = sim::generate_box({1, 1, 1}, {cells, cells, cells}, {1, 1, 1}, sim::ElementKind::tet4);
  body.materials = {sim::MaterialSpec{}};
  body.pins = {sim::Pin{sim::InGroup{"bottom"}, "xyz", {}, {}}};
  body.loads.tractions = {{.where = sim::InGroup{"top"}, .value = {0, 200, 0}}};
  document.scene.bodies = {body};
  return document;
}

std::vector<render::Arrow> arrows_of(const Document& document, const sim::System& system, const sim::State& state) {
  std::vector<render::Arrow> arrows;
  Arrows(system, document).add(state, arrows);
  return arrows;
}

Vec3 sum_of(const std::vector<render::Arrow>& arrows) {
  Vec3 sum = Vec3::Zero();
  for (const render::Arrow& a : arrows) sum += Vec3(a.to[0] - a.from[0], a.to[1] - a.from[1], a.to[2] - a.from[2]);
  return sum;
}

TEST(Arrows, AddUpToTheLoadWhateverTheMesh) {
  std::size_t counts[2] = {};
  for (int i = 0; i < 2; ++i) {
    Document document = pulled_box(i == 0 ? 3 : 14);
    document.look.forces = true;
    document.look.force_scale = 1e-2;
    const sim::System system(document.scene);
    const auto arrows = arrows_of(document, system, system.initial_state());  // undeformed: nothing to hold yet
    EXPECT_NEAR((sum_of(arrows) - Vec3(0, 2, 0)).norm(), 0, 1e-4);            // 200 N
    counts[i] = arrows.size();
  }
  EXPECT_LT(counts[1], 8 * counts[0]);  // the mesh has 18 times as many nodes on its top
}

TEST(Arrows, WhatIsHeldAnswersTheElasticForce) {
  Document document = pulled_box(3);
  document.scene.bodies[0].loads.tractions.clear();
  document.look.forces = true;
  document.look.force_scale = 1e-6;
  const sim::System system(document.scene);
  sim::State state = system.initial_state();
  for (Eigen::Index i = 1; i < state.x.size(); i += 3) state.x[i] *= 1.1;  // stretched upwards
  EXPECT_LT(sum_of(arrows_of(document, system, state)).y(), -0.01);        // so the pins hold it down
}

// What pins may take is guessed before the first step, for the default length: of a thin sheet it is as much less.
TEST(Arrows, APinThatMovesLeavesTheArrowsOfASheetTheirLength) {
  const auto longest = [](bool moves) {
    Document document;
    sim::Body sheet;
    sheet.name = "sheet";
    sheet.mesh = sim::generate_rectangle({2, 2}, {4, 4}, {1, 1}, sim::ElementKind::tri3);
    sheet.mesh.X.conservativeResize(3, Eigen::NoChange);
    sheet.mesh.X.row(2).setZero();
    sheet.thickness = 0.005;
    sheet.materials = {sim::MaterialSpec{"stable-neo-hookean", 2e5, 0.3, 500, ""}};
    const auto pin_at = [](double x) { return sim::Pin{sim::Sphere{{x, 0, 0}, 0.1}, "xyz", {}, {}}; };
    sheet.pins = {pin_at(0), pin_at(2)};
    if (moves) sheet.pins[1].motion = {{}, {.t = 1, .translate = {0, 1, 0}}};
    document.scene.bodies = {sheet};
    document.look.forces = true;
    const sim::System system(document.scene);
    sim::State state = system.initial_state();
    for (Eigen::Index i = 0; i < state.x.size(); i += 3) state.x[i] *= 1.01;
    double length = 0;
    for (const render::Arrow& a : arrows_of(document, system, state)) length = std::max(length, sum_of({a}).norm());
    return length;
  };
  EXPECT_GT(longest(true), 0.2 * longest(false));
}

// A box a tenth of the barrier above a plane: what the plane presses, in a colour of its own, and nothing else.
TEST(Arrows, ContactIsShownAlone) {
  Document document = pulled_box(3);
  document.scene.bodies[0].pins.clear();
  document.scene.obstacles = {{sim::Plane{{0, -1e-4, 0}, {0, 1, 0}}, 0}};
  document.look.force_scale = 1e-3;
  document.look.contact_forces = true;
  const sim::System system(document.scene);
  const sim::State state = system.initial_state();
  const auto alone = arrows_of(document, system, state);
  ASSERT_FALSE(alone.empty());
  for (const render::Arrow& arrow : alone) EXPECT_EQ(arrow.colour, alone[0].colour);
  const Vec3 sum = sum_of(alone);
  EXPECT_GT(sum.y(), 0);
  EXPECT_NEAR(sum.y(), 1e-3 * sim::loads(system, state).contact.sum(), 1e-5 * sum.y());
  document.look.contact_forces = false;
  document.look.forces = true;
  const auto all = arrows_of(document, system, state);
  EXPECT_NEAR((sum_of(all) - sum - Vec3(0, 0.2, 0)).norm(), 0, 1e-5 * sum.y());  // and the 200 N that pull
}

TEST(Arrows, VelocitiesAreWaysInATime) {
  Document document = pulled_box(2);
  document.look.velocities = true;
  document.look.velocity_scale = 0.25;
  const sim::System system(document.scene);
  sim::State state = system.initial_state();
  for (Eigen::Index i = 0; i < state.v.size(); i += 3) state.v.segment<3>(i) = Vec3(0, 0, 4);
  const auto arrows = arrows_of(document, system, state);
  ASSERT_FALSE(arrows.empty());
  for (const render::Arrow& arrow : arrows) {
    EXPECT_NEAR(arrow.to[2] - arrow.from[2], 1, 1e-6);
    EXPECT_NEAR(arrow.to[0] - arrow.from[0], 0, 1e-6);
  }
}

TEST(Arrows, NoneUnlessAsked) {
  const Document document = pulled_box(2);
  const sim::System system(document.scene);
  EXPECT_TRUE(arrows_of(document, system, system.initial_state()).empty());
}

}  // namespace
}  // namespace app
