// The window of `ritz view`: what is done in it is shown, logged and replayed.
#include <algorithm>

#include "app/base/text.h"
#include "app/panel/panel.h"
#include "app/session/session_file.h"
#include "render/compare.h"
#include "tests/app/window_scene.h"

namespace app {
namespace {

render::Image right_of(const render::Image& image, int left) {
  render::Image right{image.width - left, image.height, {}};
  for (int y = 0; y < image.height; ++y) {
    const auto row = image.rgba.begin() + std::ptrdiff_t{4} * image.width * y;
    right.rgba.insert(right.rgba.end(), row + std::ptrdiff_t{4} * left, row + std::ptrdiff_t{4} * image.width);
  }
  return right;
}

TEST_F(WindowTest, IsDrivenByKeysAndMouseAndClosedCleanly) {
  const auto ritz = view();
  const render::Image first = screenshot();
  for (int k = 0; k < 3; ++k) tool("key Right");
  tool("key Left");
  for (int k = 0; k < 2; ++k) tool("key Right");  // to a step of which there is a frame
  tool("key w");
  tool("mousemove 450 200 mousedown 1");
  tool("mousemove 470 210");
  tool("mousemove 490 215");
  tool("mouseup 1");
  tool("mousemove 450 200 mousedown 3");
  tool("mousemove 440 220");
  tool("mouseup 3 click 4");
  const render::Image last = screenshot();
  tool("key ctrl+q");
  EXPECT_EQ(ritz->wait(10s), 0) << read_all(log("ritz"));
  const std::vector<std::string> what = done();
  EXPECT_EQ(std::ranges::count(what, "back"), 1);
  EXPECT_EQ(std::ranges::count(what, "set"), 1);
  EXPECT_GE(std::ranges::count(what, "camera"), 4) << "orbit, pan, zoom";
  const SessionFile session = read_session(folder_ / "session.toml");
  EXPECT_EQ(session.steps, 5);
  EXPECT_FALSE(session.state_hash.empty());
  EXPECT_GT(render::compare(last, first, 40).share, 0.002) << "something has changed";
  // The picture in the window is the picture that is recorded: the screenshot, right of the panel, is the last frame of
  // the replay at that size.
  replayed({"--size", "600x400", "--panel"});
  const render::Image frame = render::decode_png(read_all(folder_ / "replay/frames/frame_00002.png"));
  const int panel = Panel::width(600, 400);
  EXPECT_LT(render::compare(right_of(frame, panel), right_of(last, panel), 8).share, 0.001);
  EXPECT_GT(render::compare(right_of(frame, panel), right_of(first, panel), 40).share, 0.01);
}

TEST_F(WindowTest, PlaysPullsAndIsReplayedToTheSameState) {
  const auto ritz = view();
  tool("key space");
  std::this_thread::sleep_for(400ms);
  tool("keydown ctrl mousemove 450 200 mousedown 1");
  for (const char* to : {"455 180", "460 160", "465 150"}) tool(std::string("mousemove ") + to);
  std::this_thread::sleep_for(200ms);
  tool("mouseup 1 keyup ctrl");
  tool("key space");
  tool("key ctrl+q");
  ASSERT_EQ(ritz->wait(10s), 0) << read_all(log("ritz"));
  const SessionFile session = read_session(folder_ / "session.toml");
  EXPECT_GT(session.steps, 5);
  replayed({"--size", "64x48"});
  EXPECT_NE(read_all(folder_ / "replay/run.json").find(session.state_hash), std::string::npos);
  EXPECT_EQ(read_all(log("replay")).find("note: the session ended"), std::string::npos);
}

TEST_F(WindowTest, ShowsWhatIsRecorded) {
  const auto ritz = view();
  for (int k = 0; k < 4; ++k) tool("key Right");
  tool("key Tab");
  const render::Image seen = screenshot();
  tool("key ctrl+q");
  ASSERT_EQ(ritz->wait(10s), 0);
  Process record({ritz_program, "record", (folder_ / "beam.toml").string(), "-o", (folder_ / "run").string(), "--size",
                  "600x400", "--seconds", "0.1"},
                 log("record"), "");
  ASSERT_EQ(record.wait(60s), 0) << read_all(log("record"));
  const render::Image recorded = render::decode_png(read_all(folder_ / "run/frames/frame_00002.png"));
  const render::Difference difference = render::compare(recorded, seen, 8);
  EXPECT_LT(difference.share, 0.001) << "largest difference " << difference.largest;
}

TEST_F(WindowTest, EndsWithTheLogWholeOnCtrlC) {
  const auto ritz = view();
  tool("key Right");
  screenshot();  // the key before it has been taken
  ritz->signal(SIGINT);
  EXPECT_EQ(ritz->wait(10s), 0) << read_all(log("ritz"));
  EXPECT_EQ(read_session(folder_ / "session.toml").steps, 1);
}

// What the window takes settles: states to step back to are at most 2,000, small ones here; allocators and the
// rasteriser keep what they have once used. The highest of 10 s is no more than 500 kB above that of the 10 s before: a
// leak of 50 kB a second does not pass.
TEST_F(WindowTest, MemoryDoesNotGrow) {
  std::string scene = session_beam;
  scene.replace(scene.find("[4, 2, 2]"), 9, "[1, 1, 1]");
  write_all(folder_ / "beam.toml", scene);
  const auto ritz = view();
  const auto highest = [&] {  // kB, of the next 10 s
    long most = 0;
    for (int k = 0; k < 10; ++k) {
      std::this_thread::sleep_for(1s);
      std::istringstream text(read_all("/proc/" + std::to_string(ritz->pid()) + "/status"));
      for (std::string line; std::getline(text, line);) {
        if (line.starts_with("VmRSS:")) most = std::max(most, std::stol(line.substr(6)));
      }
    }
    return most;
  };
  tool("key space");
  std::vector<long> memory = {highest(), highest()};
  while (memory.back() - memory[memory.size() - 2] > 500 && memory.size() < 9) memory.push_back(highest());
  EXPECT_GT(memory[0], 0);
  EXPECT_LE(memory.back() - memory[memory.size() - 2], 500) << testing::PrintToString(memory);
  tool("key ctrl+q");
  EXPECT_EQ(ritz->wait(10s), 0);
}

TEST_F(SessionScene, WithoutADisplayOneLineNamesRecord) {
  Process ritz({ritz_program, "view", (folder_ / "beam.toml").string(), "--quiet"}, (folder_ / "log").string(), "");
  EXPECT_EQ(ritz.wait(20s), 2);
  const std::string said = read_all(folder_ / "log");
  EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
  EXPECT_NE(said.find("`ritz record "), std::string::npos) << said;
}

}  // namespace
}  // namespace app
