// What a scene can do without.
#include "app/base/exit_code.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_text.h"
#include "app/trade/case_file.h"
#include "app/trade/features.h"
#include "app/trade/trade.h"
#include "render/png.h"
#include "tests/app/trade_scene.h"

namespace app {
namespace {

TEST_F(TradeTest, AblationNamesWhatTheSceneHas) {
  const std::string text = std::string(plate_scene) +
                           "damping.beta = 0.01\nmass = \"consistent\"\n[[obstacle]]\nsphere = [[9, 9], 1]\n"
                           "[[obstacle]]\nplane = { point = [0, -9], normal = [0, 1] }\nfriction = 0.3\n";
  Options with = options(text.c_str());
  with.trade.ablate = true;
  const Document scene = load_scene(with.scene);
  std::vector<std::string> names;
  for (const TradeCase& which : without_features(scene)) names.push_back(which.label);
  EXPECT_EQ(list_toml(scene, "obstacle", 1).find("plane"), std::string::npos);  // in the order of the scene
  EXPECT_EQ(list_toml(scene, "obstacle", 0).find("sphere"), std::string::npos);
  const std::vector<std::string> expected = {"plate: damping beta",
                                             "plate: consistent mass (lumped instead)",
                                             "plate: tractions",
                                             "plate: nonlinear material (linear instead)",
                                             "obstacle 0",
                                             "obstacle 1",
                                             "obstacle 1: friction",
                                             "second order in time (backward-euler instead)",
                                             "definiteness fix (exact tangent instead)",
                                             "tolerance (1e-2 instead)"};
  EXPECT_EQ(names, expected);
  testing::internal::CaptureStdout();
  ASSERT_EQ(trade(with), exit_done);
  const std::string table = testing::internal::GetCapturedStdout();
  const auto line = [&](const std::string& name) {
    const std::size_t at = table.find("  " + name + " ");
    return at == std::string::npos ? std::string() : table.substr(at, table.find('\n', at) - at);
  };
  EXPECT_NE(line("obstacle 1").find("it can go"), std::string::npos) << table;  // never touched
  EXPECT_EQ(line("plate: tractions").find("it can go"), std::string::npos) << table;
  EXPECT_TRUE(std::filesystem::exists(with.out / "ablate.csv"));
}

// A scene in a basis beside the same in all of its nodes: nothing else is run, and the training is told with its run.
TEST_F(TradeTest, AblationDrawsTheSceneBesideWhatItIsWithout) {
  Options with = options((std::string(plate_scene) + "basis = { kind = \"modes\", count = 6 }\n").c_str());
  with.trade.ablate = with.trade.show = with.still = true;
  with.trade.show_names = {"basis"};
  with.width = 320;
  with.height = 180;
  with.samples = 1;
  testing::internal::CaptureStdout();
  ASSERT_EQ(trade(with), exit_done);
  const std::string table = testing::internal::GetCapturedStdout();
  EXPECT_NE(table.find("plate: basis (all nodes instead)"), std::string::npos) << table;
  EXPECT_EQ(table.find("tractions"), std::string::npos) << table;
  std::vector<std::filesystem::path> pictures;
  for (const auto& entry : std::filesystem::directory_iterator(with.out / "show")) pictures.push_back(entry.path());
  ASSERT_EQ(pictures.size(), 1U);
  EXPECT_EQ(render::decode_png(read_all(pictures[0])).width, 2 * 160);
  int trained = 0;
  for (const auto& entry : std::filesystem::directory_iterator(with.out / "cases")) {
    const std::optional<CaseRun> run = decode_case(read_all(entry.path()));
    if (run) trained += run->training > 0;
  }
  EXPECT_EQ(trained, 1) << "the scene, and not the one in all nodes";
  with.trade.show_names = {"wings"};
  EXPECT_NE(error_of([&] { trade(with); }).find("--show wings: no feature of the scene is called so: "),
            std::string::npos);
}

}  // namespace
}  // namespace app
