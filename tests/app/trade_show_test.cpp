// `ritz trade --show`: runs beside each other, and what is said where they cannot be.
#include "app/base/exit_code.h"
#include "app/command/cli.h"
#include "app/trade/side_by_side.h"
#include "render/png.h"
#include "tests/app/trade_scene.h"

namespace app {
namespace {

namespace fs = std::filesystem;

class TradeShow : public TradeTest {
 protected:
  Options shown() const {
    Options show = options();
    show.width = 320;
    show.height = 180;
    show.samples = 1;
    show.trade.show = true;
    show.trade.keep_mesh = true;
    show.trade.target = "1%";
    show.trade.minutes = 0.3;
    return show;
  }
  static std::size_t count(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
  }
};

// Two runs whose bodies are moved by known lengths: what is drawn is their distance on the screen.
TEST_F(TradeShow, TheDistanceIsThatOnTheScreen) {
  const Comparison comparison = make_comparison(options());
  CaseRun reference, run;
  for (int k = 0; k < 3; ++k) {
    const Eigen::VectorXd X = comparison.points.X.reshaped();
    Eigen::VectorXd moved = X;
    for (Eigen::Index i = 0; i < X.size(); i += 2) moved[i] += k == 1 ? 0.02 : 0.01 * k / 2;
    for (CaseRun* one : {&reference, &run}) one->path.dimension = 2;
    reference.path.x.push_back(X);
    run.path.x.push_back(moved);
    for (CaseRun* one : {&reference, &run}) one->path.t.push_back(k / 30.0);
  }
  const auto apart = pixels_apart(comparison, run, reference);
  const render::View& view = comparison.view;
  const double per_metre =
      (view.to_window({1, 0, 0}, 1920, 1080) - view.to_window({0, 0, 0}, 1920, 1080)).head<2>().norm();
  ASSERT_EQ(apart.size(), 3U);
  EXPECT_EQ(apart[0].maxCoeff(), 0);
  EXPECT_NEAR(apart[1].minCoeff(), 0.02 * per_metre, 1e-3 * per_metre * 0.02 + 1e-3);
  EXPECT_EQ(frame_apart_most(comparison, {{"", "", &reference}, {"", "", &run}}, 9), 1);
  EXPECT_EQ(frame_apart_most(comparison, {{"", "", &reference}, {"", "", &run}}, 1), 0);
}

TEST_F(TradeShow, DrawsTheFrameInWhichTheyDifferMost) {
  Options still = shown();
  still.still = true;
  still.trade.show_names = {"backward-euler h=1/30"};
  testing::internal::CaptureStdout();
  ASSERT_EQ(trade(still), exit_done);
  testing::internal::GetCapturedStdout();
  ASSERT_EQ(count(still.out / "show"), 1U);
  const render::Image image = render::decode_png(read_all(fs::directory_iterator(still.out / "show")->path()));
  EXPECT_EQ(image.height, 180) << "pictures and, below them, differences";
  EXPECT_EQ(image.width % 160, 0);
  EXPECT_GE(image.width, 3 * 160) << "reference, scene, advice, the named run";
  // The reference is no distance from itself; the named run is, and looks different.
  const auto column = [&](int x, bool below) {
    std::vector<std::uint8_t> pixels;
    for (int y = below ? 90 : 0; y < (below ? 180 : 90); ++y)
      for (int i = 0; i < 160; ++i) pixels.push_back(image.rgba[4 * (std::size_t(y) * image.width + x * 160 + i)]);
    return pixels;
  };
  EXPECT_NE(column(0, true), column(image.width / 160 - 1, true));
}

// A name that none has, and one that several have, is an error that lists what there is, before anything is run or
// written: in a new folder, over what lies in one, and of what is collected there.
TEST_F(TradeShow, RefusesWrongNamesBeforeAnythingIsWritten) {
  Options wrong = shown();
  const auto refused = [&](const char* name) {
    wrong.trade.show_names = {name};
    const std::string error = error_of([&] { trade(wrong); });
    EXPECT_NE(error.find(std::string("--show ") + name + ": "), std::string::npos) << error;
    return error;
  };
  EXPECT_NE(refused("backward-elastic").find("there are: "), std::string::npos);
  EXPECT_NE(refused("backward-elastic").find("tr-bdf2 h=1/30"), std::string::npos);
  EXPECT_NE(refused("tr-bdf2").find("part of the names of several: "), std::string::npos);
  EXPECT_FALSE(fs::exists(wrong.out)) << "nothing is written";
  Options one = shown();
  one.trade.show = false;
  one.trade.one_case = 0;
  ASSERT_EQ(trade(one), exit_done);
  write_all(wrong.out / "trade.csv", "an earlier table");
  wrong.trade.collect = true;
  EXPECT_NE(refused("backward-euler").find("no run is called so; there are: the scene"), std::string::npos);
  wrong.overwrite = true;
  refused("the scene");
  wrong.overwrite = wrong.trade.collect = false;
  refused("backward-elastic");
  EXPECT_EQ(read_all(wrong.out / "trade.csv"), "an earlier table");
  EXPECT_EQ(count(wrong.out / "cases"), 1U);
}

// A run that the search would not make is made where it is named.
TEST_F(TradeShow, RunsWhatIsNamed) {
  Options named = shown();
  named.still = true;
  named.trade.show_names = {"trapezoidal h=1/210"};
  testing::internal::CaptureStdout();
  ASSERT_EQ(trade(named), exit_done);
  testing::internal::GetCapturedStdout();
  EXPECT_TRUE(rows(named.out).contains("trapezoidal h=1/210"));
}

TEST_F(TradeShow, RefusesAVideoThatCannotBeBeforeAnythingIsRun) {
  Options video = shown();
  video.video = folder_ / "film.txt";
  EXPECT_NE(error_of([&] { trade(video); }).find("must end in .mp4 or .gif"), std::string::npos);
  EXPECT_FALSE(fs::exists(video.out));
}

TEST_F(TradeShow, CollectsOnlyFromAFolderThatIsThere) {
  Options none = options();
  none.trade.collect = true;
  EXPECT_EQ(error_of([&] { trade(none); }),
            none.out.string() + ": there is no such folder, so there is nothing to collect");
  EXPECT_FALSE(fs::exists(none.out));
}

TEST_F(TradeShow, DrawsAllFrames) {
  Options show = shown();
  testing::internal::CaptureStdout();
  ASSERT_EQ(trade(show), exit_done);
  testing::internal::GetCapturedStdout();
  EXPECT_EQ(count(show.out / "show"), 12U) << "0.4 s at 30 frames a second";
  EXPECT_TRUE(fs::exists(show.out / "show/frame_00012.png"));
}

TEST(TradeCommandLine, ShowTakesNamesOrNone) {
  const auto parsed = [](std::vector<std::string> words) {
    std::ostringstream out, err;
    int code = 0;
    words.insert(words.begin(), "trade");
    return parse_command_line(words, out, err, code);
  };
  const auto none = parsed({"a.toml", "--show"}), two = parsed({"a.toml", "--show", "one", "two words", "--still"}),
             without = parsed({"a.toml"});
  ASSERT_TRUE(none && two && without);
  EXPECT_TRUE(none->trade.show);
  EXPECT_TRUE(none->trade.show_names.empty());
  EXPECT_EQ(two->trade.show_names, (std::vector<std::string>{"one", "two words"}));
  EXPECT_TRUE(two->still);
  EXPECT_FALSE(without->trade.show);
  EXPECT_FALSE(parsed({"a.toml", "--still"})) << "it is of --show";
  for (const char* other : {"--jobs", "--case=0", "--compare=b.toml"})
    EXPECT_FALSE(parsed({"a.toml", other, "--show"})) << other;
}

}  // namespace
}  // namespace app
