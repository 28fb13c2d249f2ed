// Every scene with contact that comes with Ritz, frame by frame: nothing crosses, by a search that shares no code with
// the program's own.
//   build/app_tests --gtest_filter='ContactScenes*'                the longest ones up to their first impacts
//   RITZ_WHOLE=1 build/app_tests --gtest_filter='ContactScenes*'   each to its end
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "app/scene/simulation.h"
#include "sim/stepper.h"
#include "tests/sim/crossings.h"

namespace app {
namespace {

struct ContactScene {
  const char* name;
  double seconds;  // that every build steps; 0: all
};

const ContactScene contact_scenes[] = {
    {"arch", 0},   {"bears-in-a-bowl", 0.3}, {"cloth-on-ball", 0.35}, {"newton-cradle", 0.8}, {"press", 0},
    {"tumble", 0}, {"twisted-rods", 1},      {"two-boxes", 0},
};

std::filesystem::path file_of(const std::string& name) {
  return std::filesystem::path(RITZ_SOURCE_DIR) / "assets/scenes" / (name + ".toml");
}

class ContactScenes : public testing::TestWithParam<ContactScene> {};

TEST_P(ContactScenes, NothingCrosses) {
  Options options;
  options.scene = file_of(GetParam().name);
  if (GetParam().seconds > 0 && std::getenv("RITZ_WHOLE") == nullptr)
    options.overrides = {{"time.seconds", std::to_string(GetParam().seconds), "test"}};
  const Simulation simulation = build_simulation(options);
  const sim::Scene& scene = simulation.document.scene;
  sim::State state = simulation.system->initial_state();
  const auto stepper = sim::make_stepper(*simulation.system, 1);
  // What has no contact with itself may fold into itself.
  const bool own = std::ranges::any_of(
      scene.contacts, [](const sim::Contact& c) { return !c.between.empty() && c.between[0] == c.between[1]; });
  bool touched = false;
  while (state.step < simulation.last_step()) {
    const sim::StepReport report = stepper->step(state);
    ASSERT_EQ(report.failure, "") << "step " << state.step;
    EXPECT_TRUE(report.converged) << "step " << state.step;
    if (state.step % simulation.system->steps_per_frame() != 0) continue;
    for (const sim::ContactReport& contact : simulation.system->contacts(state)) touched = touched || contact.pairs > 0;
    ASSERT_EQ(sim::test::count_crossings(scene, state.x, own, simulation.system->time(state.step)), 0)
        << "step " << state.step;
    ASSERT_EQ(sim::test::count_entered(scene, state.x), 0) << "step " << state.step;
  }
  // Bodies of a scene without contact may meet a sphere.
  EXPECT_TRUE(touched || scene.contacts.empty());
}

INSTANTIATE_TEST_SUITE_P(All, ContactScenes, testing::ValuesIn(contact_scenes), [](const auto& info) {
  std::string name = info.param.name;
  std::erase(name, '-');
  return name;
});

// A scene with contact is in the list above.
TEST(ContactScenesList, HasEveryScene) {
  std::set<std::string> here, named;
  for (const ContactScene& scene : contact_scenes) named.insert(scene.name);
  for (const auto& entry : std::filesystem::directory_iterator(file_of("").parent_path())) {
    if (entry.path().extension() != ".toml") continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);)
      if (line.starts_with("[[contact]]")) here.insert(entry.path().stem().string());
  }
  for (const std::string& name : here) EXPECT_TRUE(named.count(name)) << name;
}

}  // namespace
}  // namespace app
