#include <gtest/gtest.h>

#include "app/base/exit_code.h"
#include "app/base/output_file.h"
#include "app/command/commands.h"
#include "render/png.h"
#include "tests/app/scene_fixture.h"

namespace app {
namespace {

namespace fs = std::filesystem;

// A single element falls past a camera that stands still: four frames of 64 x 48.
class Expect : public testing::Test {
 protected:
  Expect() {
    write_all(folder_ / "tet.toml", R"(
[time]
seconds = 0.3
fps = 10
[[body]]
name = "tet"
mesh = { file = "tet.node" }
[camera]
eye = [0.3, 0.3, 4]
target = [0.3, 0.3, 0]
)");
    write_all(folder_ / "tet.node", "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n");
    write_all(folder_ / "tet.ele", "1 4 0\n0 0 1 2 3\n");
    EXPECT_EQ(record(options("stored")), exit_done);
  }

  Options options(const std::string& out) const {
    Options options;
    options.scene = folder_ / "tet.toml";
    options.out = folder_ / out;
    options.width = 64;
    options.height = 48;
    options.quiet = true;
    return options;
  }
  Options expecting(const std::string& out) const {
    Options with = options(out);
    with.expect = folder_ / "stored/frames";
    return with;
  }
  std::string table(const std::string& out) const { return read_all(folder_ / out / "expect.csv"); }

  TemporaryFolder folder_;
};

TEST_F(Expect, TheSameFramesAreAsExpected) {
  EXPECT_EQ(record(expecting("again")), exit_done);
  EXPECT_FALSE(fs::exists(folder_ / "again/differences"));
  EXPECT_TRUE(table("again").starts_with("frame,largest_difference,share,verdict\n0,0,0,equal\n1,0,0,equal\n"));
}

TEST_F(Expect, OtherFramesAreShownAndExitWithFour) {
  Options moved = expecting("moved");
  moved.overrides = {{"body.0.velocity", "[1, 0, 0]", "test"}};
  EXPECT_EQ(record(moved), exit_frames_differ);
  EXPECT_FALSE(fs::exists(folder_ / "moved/differences/frame_00000.png"));  // frame 0 is the same
  const render::Image picture = render::decode_png(read_all(folder_ / "moved/differences/frame_00002.png"));
  EXPECT_EQ(picture.width, 64);
  EXPECT_NE(table("moved").find("0,0,0,equal"), std::string::npos) << table("moved");
  EXPECT_NE(table("moved").find("differs"), std::string::npos) << table("moved");
  EXPECT_TRUE(fs::exists(folder_ / "moved/frames/frame_00003.png"));  // what was drawn is there as ever
  moved.out = folder_ / "tolerant";
  moved.expect_share = 1;
  EXPECT_EQ(record(moved), exit_done);
}

TEST_F(Expect, OnlyStoredFramesAreCompared) {
  fs::remove(folder_ / "stored/frames/frame_00001.png");
  write_all(folder_ / "stored/frames/notes.txt", "frames of last week");
  EXPECT_EQ(record(expecting("fewer")), exit_done);
  EXPECT_EQ(table("fewer").find("\n1,"), std::string::npos);
  // What was stored and is not drawn is missing.
  Options still = expecting("still");
  still.still = true;
  EXPECT_EQ(record(still), exit_frames_differ);
  EXPECT_NE(table("still").find("0,0,0,not drawn"), std::string::npos) << table("still");
}

TEST_F(Expect, AnotherSizeIsToldBeforeTheFirstStep) {
  Options larger = expecting("larger");
  larger.width = 80;
  const std::string message = error_of([&] { record(larger); });
  EXPECT_NE(message.find("frame_00000.png is 64x48, and this run draws 80x48; take --size 64x48"), std::string::npos)
      << message;
  EXPECT_FALSE(fs::exists(folder_ / "larger/steps.csv"));
}

TEST_F(Expect, WhatCannotBeComparedIsSaid) {
  Options nowhere = expecting("a");
  nowhere.expect = folder_ / "nowhere";
  EXPECT_NE(error_of([&] { record(nowhere); }).find("there is no such folder"), std::string::npos);
  fs::create_directory(folder_ / "empty");
  nowhere.expect = folder_ / "empty";
  EXPECT_NE(error_of([&] { record(nowhere); }).find("holds no frame_NNNNN.png"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "a"));
  Options itself = expecting("stored");
  itself.overwrite = true;
  EXPECT_NE(error_of([&] { record(itself); }).find("writes its own frames"), std::string::npos);
  write_all(folder_ / "stored/frames/frame_00001.png", "no picture");
  const std::string message = error_of([&] { record(expecting("b")); });
  EXPECT_NE(message.find("frame_00001.png: the expected frame is not a PNG"), std::string::npos) << message;
}

}  // namespace
}  // namespace app
