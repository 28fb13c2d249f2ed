// Curves over time: those of a run that was interrupted and gone on with are those of one that was not, and those of a
// window that goes back end where it is.
#include "app/base/exit_code.h"
#include "app/command/commands.h"
#include "app/picture/frame_history.h"
#include "tests/app/lecture/deck.h"
#include "tests/app/workbench_scene.h"

namespace app {
namespace {

const std::filesystem::path damping = lecture_deck / "13-damping.toml";

class CurvesTest : public WorkbenchTest {
 protected:
  Options page(const std::string& seconds, const std::filesystem::path& out) const {
    Options options;
    options.scene = damping;
    options.quiet = true;
    options.width = 160;
    options.height = 90;
    options.overrides = {{"time.seconds", seconds, "--seconds"}};
    options.out = out;
    return options;
  }
  void resume(const std::string& seconds, const std::filesystem::path& folder) const {
    Options options = page(seconds, {});
    options.resume = folder;
    ASSERT_EQ(record(options), exit_done);
  }
  static void expect_equal(const std::filesystem::path& folder, const std::filesystem::path& straight) {
    for (const char* file : {"numbers.csv", "curves.csv", "frames/frame_00045.png"})
      EXPECT_EQ(read_all(folder / file), read_all(straight / file)) << file;
  }
};

TEST_F(CurvesTest, AreRestoredWhereARunGoesOn) {
  ASSERT_EQ(record(page("0.75", folder_ / "straight")), exit_done);
  const std::string curves = read_all(folder_ / "straight/curves.csv");
  EXPECT_EQ(curves.substr(0, curves.find('\n')), "frame,α.p,β.p,q");
  EXPECT_EQ(std::ranges::count(curves, '\n'), 47) << "a header and frames 0 to 45";
  EXPECT_NE(read_all(folder_ / "straight/numbers.csv").find("\n45,ratio.law,"), std::string::npos);
  ASSERT_EQ(record(page("0.35", folder_ / "stopped")), exit_done);
  // Killed later than its last checkpoint: the tables have rows, and the folder frames, that the state has not.
  std::filesystem::copy(folder_ / "straight", folder_ / "killed", std::filesystem::copy_options::recursive);
  std::filesystem::copy_file(folder_ / "stopped/state.bin", folder_ / "killed/state.bin",
                             std::filesystem::copy_options::overwrite_existing);
  for (const char* folder : {"stopped", "killed"}) {
    resume("0.75", folder_ / folder);
    expect_equal(folder_ / folder, folder_ / "straight");
  }
}

TEST_F(CurvesTest, AreRefusedWhereTheyAreOfAnotherScene) {
  ASSERT_EQ(record(page("0.05", folder_ / "run")), exit_done);
  write_all(folder_ / "run/curves.csv", "frame,q\n0,1\n");
  const std::string error = error_of([&] { resume("0.1", folder_ / "run"); });
  EXPECT_NE(error.find("curves.csv: has the columns frame,q, the scene gives frame,α.p,β.p,q"), std::string::npos)
      << error;
}

// Of the plot of momenta: how long its first curve is, and where it ends.
struct Curve {
  std::size_t size;
  double end;
};
Curve curve_of(Workbench& bench) {
  const render::Stroke& stroke = bench.frame(320, 180).sheet->diagrams[0].strokes[0];
  return {stroke.points.size(), stroke.points.back()[0]};
}

TEST_F(CurvesTest, EndWhereTheWindowIs) {
  Options options;
  options.scene = damping;
  Workbench bench(options, std::make_unique<Session>(options));
  const int steps = bench.session().simulation()->system->steps_per_frame();
  const auto move = [&](render::Key pressed, int times) {
    for (int k = 0; k < times; ++k) key(bench, pressed);
  };
  move(render::Key::right, 5 * steps);
  EXPECT_EQ(curve_of(bench).size, 6U);
  move(render::Key::left, 2 * steps);
  EXPECT_EQ(curve_of(bench).size, 4U);
  EXPECT_DOUBLE_EQ(curve_of(bench).end, 3.0 / 60);
  move(render::Key::left, 1);
  EXPECT_EQ(curve_of(bench).size, 3U) << "between two frames it ends with the one before";
  move(render::Key::right, 1 + steps);
  EXPECT_EQ(curve_of(bench).size, 5U);
  key(bench, render::Key::backspace);
  EXPECT_EQ(curve_of(bench).size, 1U);
  move(render::Key::right, 2 * steps);
  EXPECT_EQ(curve_of(bench).size, 3U);
}

// A change of the scene on the way makes a new system and new exhibits; the curve has both parts.
TEST_F(CurvesTest, GoOnWhenTheSceneChanges) {
  Options options;
  options.scene = damping;
  Session session(options);
  FrameHistory history(*session.simulation());
  LargestShown largest{};
  const int steps = session.simulation()->system->steps_per_frame();
  history.add(session.state(), largest);
  for (int frame = 1; frame <= 4; ++frame) {
    for (int k = 0; k < steps; ++k) ASSERT_EQ(session.step().failure, "");
    if (frame == 2) {
      session.apply(SetKey{"body.0.material.young", "2e5"});
      history.revise(*session.simulation(), session.state(), largest);
    }
    history.add(session.state(), largest);
  }
  Moment moment{.frame = 4, .state = session.state()};
  history.fill(largest, moment);
  EXPECT_EQ(moment.sheet->diagrams[0].strokes[0].points.size(), 5U);
}

// The numbers of a window, beside its log, are those of the frames of the replay.
TEST_F(CurvesTest, NumbersOfAWindowAreThoseOfItsReplay) {
  Options options = page("1", {});
  options.log = folder_ / "session.toml";
  Workbench bench(options, std::make_unique<Session>(options));
  const int steps = bench.session().simulation()->system->steps_per_frame();
  const auto move = [&](render::Key pressed, int times) {
    for (int k = 0; k < times; ++k) key(bench, pressed);
  };
  move(render::Key::right, 3 * steps);
  move(render::Key::left, steps + 1);
  move(render::Key::right, 2 * steps);
  key(bench, render::Key::backspace);
  move(render::Key::right, steps);
  bench.finish();
  Options again = page("1", folder_ / "replayed");
  again.replay = options.log;
  ASSERT_EQ(record(again), exit_done);
  const std::string numbers = read_all(folder_ / "session.csv");
  EXPECT_NE(numbers.find("\n6,α.p,0.99170,\n"), std::string::npos) << "the seventh frame is number 1 again";
  EXPECT_EQ(numbers, read_all(folder_ / "replayed/numbers.csv"));
}

}  // namespace
}  // namespace app
