// `ritz trade --compare`: two scenes on one diagram.
#include "app/base/exit_code.h"
#include "app/base/text.h"
#include "app/trade/trade.h"
#include "tests/app/trade_scene.h"

namespace app {
namespace {

class TradeCompare : public TradeTest {
 protected:
  Options compared(const std::string& with, const std::string& text) const {
    Options both = options();
    write_all(folder_ / with, text);
    both.trade.compare = folder_ / with;
    both.trade.minutes = 0.3;
    return both;
  }
  // The identity that the table in a folder gives to the scene as it is.
  std::string identity(const Options& both, const char* which) const {
    return rows(both.out / which).at("the scene").at("id");
  }
  static std::string identity(const Options& scene) {
    return hexadecimal(case_id(make_comparison(scene), build_simulation(scene).identity, scene.threads));
  }
  // The points of a data block of the script, as "error # label".
  static std::vector<std::string> points(const std::string& script, const std::string& block) {
    std::istringstream text(script);
    std::vector<std::string> all;
    bool inside = false;
    for (std::string line; std::getline(text, line);) {
      if (inside && line != "EOD") all.push_back(line.substr(line.find(' ') + 1));
      inside = line == "$" + block + " << EOD" || (inside && line != "EOD");
    }
    return all;
  }
  // Every point of the block is on the front of that trade, with the error that its table says.
  void expect_front(const std::string& script, const std::string& block, const std::filesystem::path& folder) const {
    const auto table = rows(folder);
    const std::vector<std::string> all = points(script, block);
    EXPECT_FALSE(all.empty()) << block;
    for (const std::string& point : all) {
      const std::string label = point.substr(point.find(" # ") + 3);
      if (label.ends_with(", below")) continue;
      ASSERT_TRUE(table.contains(label)) << label;
      EXPECT_EQ(table.at(label).at("front"), "1") << label;
      const double error = 100 * std::stod(table.at(label).at("time_error"));
      EXPECT_NEAR(std::stod(point), error, 1e-9 * error) << label;
    }
  }
};

TEST_F(TradeCompare, SettingsAreMeasuredOverTheSceneAndBothFrontsAreDrawn) {
  Options both = compared("softer.toml", "[body.0.material]\nyoung = 5e3\n");
  both.trade.keep_mesh = true;
  testing::internal::CaptureStdout();
  ASSERT_EQ(trade(both), exit_done);
  const std::string said = testing::internal::GetCapturedStdout();
  const std::size_t first = said.find("Advice for the knee"), second = said.find("Advice for the knee", first + 1);
  EXPECT_NE(second, std::string::npos) << said;
  Options softer = options();
  softer.settings = both.trade.compare;
  EXPECT_EQ(identity(both, "one"), identity(options()));
  EXPECT_EQ(identity(both, "other"), identity(softer));
  EXPECT_NE(identity(options()), identity(softer));
  const std::string script = read_all(both.out / "compare.gp");
  EXPECT_NE(script.find("set label 'plate, as it is / plate, softer'"), std::string::npos) << script;
  expect_front(script, "line1", both.out / "one");
  expect_front(script, "line2", both.out / "other");
}

// A file that makes its own mesh is another scene, which keeps its title.
TEST_F(TradeCompare, ASceneIsMeasuredByItself) {
  std::string text = plate_scene;
  text.replace(text.find("\"plate\""), 7, "\"strip\"").replace(text.find("[2, 1]"), 6, "[4, 1]");
  Options both = compared("strip.toml", text);
  both.trade.keep_mesh = true;
  both.settings = folder_ / "stiff.toml";  // over both
  write_all(both.settings, "[body.0.material]\nyoung = 4e4\n");
  testing::internal::CaptureStdout();
  ASSERT_EQ(trade(both), exit_done);
  testing::internal::GetCapturedStdout();
  Options strip = options();
  strip.scene = both.trade.compare;
  strip.settings = both.settings;
  EXPECT_EQ(identity(both, "other"), identity(strip));
  EXPECT_NE(read_all(both.out / "compare.gp").find("set label 'plate / strip'"), std::string::npos);
}

// What is wrong with the second is said before anything is measured.
TEST_F(TradeCompare, RefusesWhatCannotBeCompared) {
  const Options wrong = compared("wrong.toml", "[time]\nintegrator = \"static\"\n");
  EXPECT_NE(error_of([&] { trade(wrong); }).find("there is no motion to trade"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(wrong.out));
  Options twice = compared("softer.toml", "[body.0.material]\nyoung = 5e3\n");
  twice.settings = folder_ / "softer.toml";
  EXPECT_NE(error_of([&] { trade(twice); }).find("--settings gives one already"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(twice.out));
}

}  // namespace
}  // namespace app
