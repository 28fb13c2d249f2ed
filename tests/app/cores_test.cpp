// How the cores are shared between steps and pictures.
#include "app/record/cores.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace app {
namespace {

Cores shared(const char* scene, int threads, int every = 1, const char* integrator = "backward-euler") {
  Options options;
  options.scene = std::filesystem::path(RITZ_SOURCE_DIR) / "assets/scenes" / scene;
  options.overrides = {{"time.integrator", integrator, "test"}};
  options.threads = threads;
  options.every = every;
  return share_cores(build_simulation(options), options);
}

TEST(Cores, OfTwoOneStepsTheBearAndOneDrawsIt) {
  const Cores cores = shared("bear.toml", 2);
  EXPECT_EQ(cores.stepping, 1);
  EXPECT_EQ(cores.drawing, 1);
  EXPECT_EQ(shared("bear.toml", 4).stepping, 2);
}

TEST(Cores, AllOfThemStepWhereFewFramesAreDrawn) {
  EXPECT_EQ(shared("bear.toml", 4, 50).stepping, 4);
  EXPECT_EQ(shared("bear.toml", 4, 50).drawing, 0);
}

TEST(Cores, AllOfThemDrawWhatIsSteppedInNoTime) {
  EXPECT_EQ(shared("tumble.toml", 4).drawing, 4);
  EXPECT_EQ(shared("tumble.toml", 4).stepping, 1) << "somebody steps all the same";
}

}  // namespace
}  // namespace app
