// Random bodies thrown at each other: nothing crosses, whatever the shapes, speed, step and stiffness.
//   build/sim_tests --gtest_filter='ContactDrops.*'                      the seeds that every build tries
//   RITZ_DROPS=1-500 build/sim_tests --gtest_filter='ContactDrops.*'     those seeds
#include <cstdlib>

#include "tests/sim/drops.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

struct Seeds {
  unsigned long first = 1, last = 30;
};
Seeds seeds_asked_for() {
  Seeds seeds;
  if (const char* text = std::getenv("RITZ_DROPS")) {
    char* rest = nullptr;
    seeds.first = seeds.last = std::strtoul(text, &rest, 10);
    if (*rest == '-') seeds.last = std::strtoul(rest + 1, nullptr, 10);
  }
  return seeds;
}

// What became of one.
struct Course {
  int steps = 0, most_newton = 0, newton = 0, unsolved = 0, splits = 0, touching = 0;
  std::string failure;
};

// Crossings of surfaces at each step, found without the program's own search for them.
Course course_of(const test::Drop& drop) {
  const System system(drop.scene);
  State state = system.initial_state();
  const auto stepper = make_stepper(system, 1);
  Course it;
  for (; it.steps < drop.steps; ++it.steps) {
    const StepReport report = stepper->step(state);
    it.failure = report.failure;
    if (!report.failure.empty()) break;
    it.most_newton = std::max(it.most_newton, report.newton);
    it.newton += report.newton;
    it.unsolved += !report.converged;
    it.splits += report.splits;
    for (const ContactReport& contact : system.contacts(state)) it.touching += contact.pairs > 0;
    EXPECT_TRUE(state.x.allFinite() && state.v.allFinite()) << "step " << report.step;
    EXPECT_EQ(test::count_crossings(drop.scene, state.x, drop.with_itself), 0) << "step " << report.step;
    if (::testing::Test::HasFailure()) break;
  }
  return it;
}

// A gap of 1e-12, whose direction round-off has turned: along it bodies seemed to have room.
TEST(ContactDrops, WhatRoundOffTurnsIsNotTrusted) {
  const Course it = course_of(test::drop(455));
  EXPECT_EQ(it.failure, "");
  EXPECT_GT(it.touching, 0);
}

TEST(ContactDrops, NothingCrosses) {
  const Seeds seeds = seeds_asked_for();
  int stops = 0, touched = 0;
  for (unsigned long seed = seeds.first; seed <= seeds.last; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const test::Drop drop = test::drop(seed);
    const Course it = course_of(drop);
    std::printf(
        "seed %lu: %zu bodies of %.1e Pa, %.3g m/s, h = 1/%d s, %s: %d steps, Newton %d, at most %d, "
        "%d unsolved, %d halved, %d touches%s%s\n",
        seed, drop.scene.bodies.size(), drop.scene.bodies[0].materials[0].young, drop.speed, drop.scene.time.fps,
        drop.scene.time.integrator.c_str(), it.steps, it.newton, it.most_newton, it.unsolved, it.splits, it.touching,
        it.failure.empty() ? "" : ", stopped: ", it.failure.c_str());
    std::fflush(stdout);
    stops += !it.failure.empty();
    touched += it.touching > 0;
    if (HasFailure()) break;
  }
  std::printf("%lu drops: %d stopped, %d touched\n", seeds.last - seeds.first + 1, stops, touched);
}

}  // namespace
}  // namespace sim
