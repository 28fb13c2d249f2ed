// What a trade tries, beside schemes and steps: only what the scene has.
#include <algorithm>
#include <cmath>
#include <thread>

#include "app/base/gnuplot.h"
#include "app/base/other_load.h"
#include "app/scene/scene_file.h"
#include "app/trade/advice.h"
#include "app/trade/lists.h"
#include "sim/study/sample.h"
#include "tests/app/trade_scene.h"

namespace app {
namespace {

class TradeAxes : public TradeTest {
 protected:
  std::vector<std::string> tried(const std::string& more) const {
    const Options with = options((std::string(plate_scene) + more).c_str());
    std::vector<std::string> labels;
    for (const TradeCase& which : rest_cases(load_scene(with.scene), scene_case())) labels.push_back(which.label);
    return labels;
  }
  static bool has(const std::vector<std::string>& labels, const std::string& part) {
    return std::ranges::any_of(labels, [&](const std::string& label) { return label.find(part) != std::string::npos; });
  }
};

TEST_F(TradeAxes, WhatASceneLacksIsNotTried) {
  EXPECT_FALSE(has(tried(""), "lag ")) << "nothing lags";
  EXPECT_FALSE(has(tried(""), "contact distance"));
  const auto damped = tried("damping.beta = 0.01\n");
  EXPECT_TRUE(has(damped, "lag 1") && has(damped, "lag 2"));
  EXPECT_FALSE(has(damped, "lag 0")) << "that is what the scene has";
  const auto rubbing = tried("[[obstacle]]\nplane = { point = [0, -9], normal = [0, 1] }\nfriction = 0.3\n");
  EXPECT_TRUE(has(rubbing, "lag 1"));
  EXPECT_FALSE(has(tried(""), "modes"));
  const auto held = tried("basis = { kind = \"modes\", count = 10 }\n");
  EXPECT_TRUE(has(held, ", 5 modes") && has(held, ", 20 derivatives"));
  EXPECT_FALSE(has(held, ", 10 modes")) << "that is what the scene has";
  // A small body has work for one thread only.
  const Comparison comparison = make_comparison(options());
  EXPECT_TRUE(thread_cases(*comparison.scene.system, 1, scene_case()).empty());
}

// What a basis cannot reach is seen by a reference in all nodes only.
TEST_F(TradeAxes, AReferenceHasNoBasis) {
  const Options with = options((std::string(plate_scene) + "basis = { kind = \"modes\", count = 10 }\n").c_str());
  for (const TradeCase& which : reference_cases(load_scene(with.scene), 8)) {
    EXPECT_NE(which.label.find("all nodes"), std::string::npos);
    EXPECT_FALSE(load_scene(with.scene, {}, options_of(with, which).overrides).scene.bodies[0].basis);
  }
}

TEST_F(TradeAxes, ThreadsAreNoKeyOfTheScene) {
  const TradeCase which = with(with(scene_case(), "2 threads", thread_option, "2"), "", "time.substeps", "2");
  const Options options = options_of(this->options(), which);
  EXPECT_EQ(options.threads, 2);
  EXPECT_EQ(options.overrides.size(), 1U);
  EXPECT_EQ(advice_toml(which, "why"), "# why\n\n[time]\nsubsteps = 2\n");
  const Comparison comparison = make_comparison(this->options());
  EXPECT_NE(case_id(comparison, 7, 2), case_id(comparison, 7, comparison.options.threads));
}

// Meshes that fill one surface have no node in common: nodes of one that lie outside another ride on it.
TEST_F(TradeAxes, SizesOfAFilledSurfaceAreTried) {
  write_all(folder_ / "cube.obj",
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
            "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  const Options cube = options(
      "[time]\nseconds = 0.2\n[[body]]\nname = \"cube\"\nmesh = { surface = \"cube.obj\", size = 0.4 }\n"
      "material = { young = 1e5 }\n");
  const Comparison comparison = make_comparison(cube);
  std::vector<std::string> labels;
  for (const MeshChange& change : mesh_changes(comparison.scene.document)) {
    labels.push_back(change.change.label);
    const auto size =
        std::ranges::find(change.change.settings, "body.0.mesh.size", &std::pair<std::string, std::string>::first);
    const bool halved = change.change.label.starts_with("size halved");
    if (halved) {
      ASSERT_NE(size, change.change.settings.end());
      EXPECT_EQ(std::stod(size->second), 0.2);
    }
    if (change.growth > 4) continue;
    const Simulation other = build_simulation(options_of(cube, change.change));
    const sim::Sampler sampler(*other.system, comparison.points);
    const Eigen::VectorXd at_rest = sampler.positions(other.system->initial_state());
    EXPECT_LT((at_rest - comparison.points.X.reshaped()).cwiseAbs().maxCoeff(), 1e-9) << change.change.label;
  }
  for (const char* expected : {"size doubled, tet4", "tet10", "size halved, tet4", "size halved, tet10"})
    EXPECT_NE(std::ranges::find(labels, expected), labels.end()) << expected;
}

// Runs of the reference are measured settings like all others: where one meets the target, the target is met.
TEST(TradeAdvice, TakesARunOfTheReferenceWhereThatMeetsTheTarget) {
  std::vector<CaseRun> runs(2);
  std::vector<Score> scores(2);
  for (int k = 0; k < 2; ++k) {
    runs[k].status = CaseStatus::done;
    runs[k].which.axis = k == 0 ? Axis::reference : Axis::time;
    scores[k].run = &runs[k];
    scores[k].seconds = 3 - k;
    scores[k].bound = k == 0 ? Apart{0.002, 0.004, 2} : Apart{0.019, 0.03, 19};
  }
  const Goal goal{Goal::Kind::error, 0.01, "1%"};
  const Score* const chosen = choose({&scores[0], &scores[1]}, goal);
  EXPECT_EQ(chosen, &scores[0]);
  EXPECT_TRUE(meets(*chosen, goal));
}

// What this program does itself is no load of others.
TEST(OtherLoad, IsWhatOtherProgramsDo) {
  const OtherLoad load;
  const double before = own_cpu_seconds();
  double sum = 0;
  while (own_cpu_seconds() < before + 0.2) sum += std::sqrt(sum + 1);
  EXPECT_GT(sum, 0);
  const auto cores = load.cores();
  if (!cores) GTEST_SKIP() << "the system does not tell";
  EXPECT_GE(*cores, 0);
  EXPECT_LT(*cores, std::thread::hardware_concurrency() + 0.1);
}

TEST(Gnuplot, SaysWhyItHasNotDrawn) {
  const TemporaryFolder folder;
  write_all(folder / "bad.gp", "set yrange [inf:0]\nplot 1/0\n");
  const std::string before = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  EXPECT_NE(run_gnuplot(folder / "bad.gp").find("apt-get install gnuplot-nox"), std::string::npos);
  setenv("PATH", before.c_str(), 1);
  if (run_gnuplot(folder / "bad.gp").starts_with("no gnuplot here")) GTEST_SKIP();
  EXPECT_NE(run_gnuplot(folder / "bad.gp").find("gnuplot failed on"), std::string::npos);
  write_all(folder / "good.gp", "set terminal svg\nset output '" + (folder / "good.svg").string() + "'\nplot x\n");
  EXPECT_EQ(run_gnuplot(folder / "good.gp"), "");
}

}  // namespace
}  // namespace app
