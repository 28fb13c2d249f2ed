// The commands record and run, end to end on a small beam.
#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "app/base/exit_code.h"
#include "app/base/output_file.h"
#include "app/command/commands.h"
#include "app/run/state_file.h"
#include "tests/app/interrupt_when_there.h"
#include "tests/app/temporary_folder.h"

namespace app {
namespace {

constexpr const char* recorded_beam = R"(
title = "beam"
[time]
seconds = 0.4
fps = 10
substeps = 2
[[body]]
name = "beam"
mesh = { box = [2, 1, 1], cells = [4, 2, 2], element = "tet4" }
material = { model = "stable-neo-hookean", young = 1e5, poisson = 0.3, density = 1000 }
pin = [{ box = [[-0.01, -1, -1], [0.01, 2, 2]] }]
[[probe]]
name = "tip"
body = "beam"
at = [2, 0.5, 0.5]
)";

// A scene in a folder of its own, and the options of a small recording of it.
class Record : public testing::Test {
 protected:
  Record() { write_all(scene(), recorded_beam); }

  std::filesystem::path scene() const { return folder_ / "beam.toml"; }

  Options options(const std::string& out) const {
    Options options;
    options.scene = scene();
    options.out = folder_ / out;
    options.width = 64;
    options.height = 48;
    options.quiet = true;
    return options;
  }

  static Options with(Options options, const std::string& key, const std::string& value) {
    options.overrides.push_back({key, value, "--set " + key + "=" + value});
    return options;
  }

  static Options resumed(Options options) {
    options.resume = options.out;
    options.out.clear();
    return options;
  }

  TemporaryFolder folder_;
};

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::istringstream text(read_all(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

// steps.csv without its last column, the seconds, which are never the same twice.
std::vector<std::string> steps_without_seconds(const std::filesystem::path& folder) {
  std::vector<std::string> lines = lines_of(folder / "steps.csv");
  for (std::string& line : lines) line.resize(line.rfind(','));
  return lines;
}

void expect_same_run(const std::filesystem::path& a, const std::filesystem::path& b) {
  EXPECT_EQ(read_all(a / "state.bin"), read_all(b / "state.bin"));
  EXPECT_EQ(read_all(a / "probes.csv"), read_all(b / "probes.csv"));
  EXPECT_EQ(steps_without_seconds(a), steps_without_seconds(b));
  if (!std::filesystem::exists(a / "frames")) return;
  ASSERT_EQ(names_in(a / "frames"), names_in(b / "frames"));
  for (const std::string& name : names_in(a / "frames")) {
    EXPECT_EQ(read_all(a / "frames" / name), read_all(b / "frames" / name)) << name;
  }
}

bool is_whole_png(const std::filesystem::path& file) {
  const std::string bytes = read_all(file);
  return bytes.starts_with("\x89PNG\r\n\x1a\n") && bytes.ends_with(std::string("IEND\xae\x42\x60\x82"));
}

bool json_says(const std::filesystem::path& folder, const std::string& text) {
  return read_all(folder / "run.json").find(text) != std::string::npos;
}

TEST_F(Record, LeavesFramesOnTimeAndARowPerStep) {
  ASSERT_EQ(record(options("out")), exit_done);
  const std::vector<std::string> frames = {"frame_00000.png", "frame_00001.png", "frame_00002.png", "frame_00003.png",
                                           "frame_00004.png"};
  EXPECT_EQ(names_in(folder_ / "out/frames"), frames);
  for (const std::string& name : frames) EXPECT_TRUE(is_whole_png(folder_ / "out/frames" / name)) << name;
  const std::vector<std::string> probes = lines_of(folder_ / "out/probes.csv");
  ASSERT_EQ(probes.size(), 1U + 9U);
  EXPECT_EQ(probes[0], "t,tip.ux,tip.uy,tip.uz");
  EXPECT_EQ(probes[1], "0,0,0,0");
  EXPECT_TRUE(probes[5].starts_with("0.2,")) << probes[5];
  const std::vector<std::string> steps = lines_of(folder_ / "out/steps.csv");
  ASSERT_EQ(steps.size(), 1U + 8U);
  EXPECT_TRUE(steps[1].starts_with("1,0.05,")) << steps[1];
  EXPECT_TRUE(steps[8].starts_with("8,0.4,")) << steps[8];
  EXPECT_TRUE(json_says(folder_ / "out", "\"status\": \"done\""));
  EXPECT_TRUE(json_says(folder_ / "out", "\"steps\": 8"));
  EXPECT_EQ(read_state_file(folder_ / "out/state.bin").state.step, 8);
}

TEST_F(Record, EveryAndStillChooseFramesWithoutRenumberingThem) {
  Options every = options("every");
  every.every = 2;
  ASSERT_EQ(record(every), exit_done);
  EXPECT_EQ(names_in(folder_ / "every/frames"),
            (std::vector<std::string>{"frame_00000.png", "frame_00002.png", "frame_00004.png"}));
  Options still = options("still");
  still.still = true;
  ASSERT_EQ(record(still), exit_done);
  EXPECT_EQ(names_in(folder_ / "still/frames"), (std::vector<std::string>{"frame_00004.png"}));
  EXPECT_EQ(read_all(folder_ / "still/frames/frame_00004.png"), read_all(folder_ / "every/frames/frame_00004.png"));
}

TEST_F(Record, NothingIsOverwrittenUnlessAskedAndThenNothingOldRemains) {
  ASSERT_EQ(record(options("out")), exit_done);
  const std::string before = read_all(folder_ / "out/frames/frame_00001.png");
  const Options shorter = with(with(options("out"), "time.seconds", "0.2"), "look.wireframe", "true");
  EXPECT_NE(error_of([&] { record(shorter); }).find("--overwrite"), std::string::npos);
  EXPECT_EQ(read_all(folder_ / "out/frames/frame_00001.png"), before);
  Options forced = shorter;
  forced.overwrite = true;
  ASSERT_EQ(record(forced), exit_done);
  EXPECT_EQ(names_in(folder_ / "out/frames").size(), 3U);
  EXPECT_NE(read_all(folder_ / "out/frames/frame_00001.png"), before);
}

TEST_F(Record, RunLeavesTheSameNumbersAndNoPicture) {
  ASSERT_EQ(record(options("recorded")), exit_done);
  ASSERT_EQ(run(options("run")), exit_done);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run/frames"));
  expect_same_run(folder_ / "run", folder_ / "recorded");
}

TEST_F(Record, TheRunFolderReproducesItself) {
  ASSERT_EQ(record(options("out")), exit_done);
  Options again = options("again");
  again.scene = folder_ / "out/run.toml";
  ASSERT_EQ(record(again), exit_done);
  expect_same_run(folder_ / "out", folder_ / "again");
}

TEST_F(Record, ThreadsDoNotChangeABit) {
  // Large enough for two threads (useful_threads in sim/stepper.cpp).
  const auto fine = [&](const std::string& out) { return with(options(out), "body.0.mesh.cells", "[16, 8, 8]"); };
  ASSERT_EQ(run(fine("one")), exit_done);
  Options two = fine("two");
  two.threads = 2;
  ASSERT_EQ(run(two), exit_done);
  expect_same_run(folder_ / "one", folder_ / "two");
}

TEST_F(Record, ResumedEqualsStraight) {
  ASSERT_EQ(record(options("straight")), exit_done);
  ASSERT_EQ(record(with(options("parts"), "time.seconds", "0.2")), exit_done);
  ASSERT_EQ(record(resumed(options("parts"))), exit_done);
  expect_same_run(folder_ / "straight", folder_ / "parts");
  EXPECT_TRUE(json_says(folder_ / "parts", "\"resumed_from_step\": 4"));
}

TEST_F(Record, FramesThatAreGoneOnWithKeepTheirSize) {
  ASSERT_EQ(record(with(options("parts"), "time.seconds", "0.2")), exit_done);
  Options larger = resumed(options("parts"));
  const std::string size = std::to_string(larger.width) + "x" + std::to_string(larger.height);
  larger.width += 16;
  EXPECT_NE(error_of([&] { record(larger); }).find("add --size " + size), std::string::npos);
}

// A colour range that the scene leaves open depends on the frames before, and so do the energies over time.
TEST_F(Record, ResumedKeepsColoursAndEnergies) {
  const auto shown = [&](const std::string& out) {
    return with(with(options(out), "look.colour", "\"stress\""), "look.energies", "true");
  };
  const auto kicked = [&](const Options& options) { return with(options, "body.0.velocity", "[0, 0, 8]"); };
  ASSERT_EQ(record(kicked(shown("straight"))), exit_done);
  ASSERT_EQ(record(with(kicked(shown("parts")), "time.seconds", "0.2")), exit_done);
  ASSERT_EQ(run(kicked(resumed(with(shown("parts"), "time.seconds", "0.3")))), exit_done);  // without pictures as well
  ASSERT_EQ(record(kicked(resumed(shown("parts")))), exit_done);
  EXPECT_EQ(read_all(folder_ / "straight/state.bin"), read_all(folder_ / "parts/state.bin"));
  EXPECT_EQ(read_all(folder_ / "straight/frames/frame_00004.png"), read_all(folder_ / "parts/frames/frame_00004.png"));
  // The range has grown, and stays: the same moment in a run of its own, which has seen nothing else, looks other.
  EXPECT_GT(read_state_file(folder_ / "straight/state.bin").totals.largest[0], 0);
}

// What a killed run leaves beyond its last state.bin is replaced when it goes on.
TEST_F(Record, WhatIsBeyondTheSavedStateIsReplaced) {
  ASSERT_EQ(record(options("straight")), exit_done);
  ASSERT_EQ(record(with(options("parts"), "time.seconds", "0.2")), exit_done);
  std::ofstream(folder_ / "parts/steps.csv", std::ios::app) << "5,0.25,1,2,3,4,5,6,7,8,9,1,1,1,0.1\n6,0.3,1,2";
  std::ofstream(folder_ / "parts/probes.csv", std::ios::app) << "0.25,1,2,3\n";
  write_all(folder_ / "parts/frames/frame_00003.png", "half a frame");
  write_all(folder_ / "parts/state.bin.tmp", "half a state");
  ASSERT_EQ(record(resumed(options("parts"))), exit_done);
  expect_same_run(folder_ / "straight", folder_ / "parts");
}

TEST_F(Record, TheStateOfAnotherSceneIsRefused) {
  ASSERT_EQ(run(with(options("out"), "time.seconds", "0.2")), exit_done);
  const Options softer = with(resumed(options("out")), "body.0.material.young", "9e4");
  EXPECT_NE(error_of([&] { run(softer); }).find("is the state of another scene"), std::string::npos);
  const Options seen = with(resumed(options("out")), "look.colour", "stress");  // another look is the same scene
  EXPECT_EQ(run(seen), exit_done);
}

TEST_F(Record, AnInterruptedRunIsWholeAndGoesOnToTheSameEnd) {
  const Options endless = with(options("out"), "time.seconds", "3000");
  std::thread interrupter = interrupt_when_there(folder_ / "out/frames/frame_00003.png");
  EXPECT_EQ(record(endless), exit_interrupted);
  interrupter.join();
  EXPECT_TRUE(json_says(folder_ / "out", "\"status\": \"interrupted\""));
  for (const std::string& name : names_in(folder_ / "out/frames"))
    EXPECT_TRUE(is_whole_png(folder_ / "out/frames" / name));
  const std::int64_t step = read_state_file(folder_ / "out/state.bin").state.step;
  EXPECT_EQ(lines_of(folder_ / "out/steps.csv").size(), static_cast<std::size_t>(step) + 1);
  const std::string seconds = std::to_string(step / 20 + 1);  // 20 steps a second
  ASSERT_EQ(record(with(resumed(options("out")), "time.seconds", seconds)), exit_done);
  ASSERT_EQ(record(with(options("straight"), "time.seconds", seconds)), exit_done);
  expect_same_run(folder_ / "straight", folder_ / "out");
}

TEST_F(Record, NumericalFailureKeepsTheLastGoodState) {
  Options unstable = with(with(options("out"), "time.integrator", "\"symplectic-euler\""), "time.substeps", "1");
  unstable = with(unstable, "time.seconds", "20");
  EXPECT_EQ(record(unstable), exit_numerical_failure);
  EXPECT_TRUE(json_says(folder_ / "out", "\"status\": \"failed\""));
  EXPECT_TRUE(json_says(folder_ / "out", "\"failed_at\""));
  const sim::State state = read_state_file(folder_ / "out/state.bin").state;  // finite, or it would be refused
  EXPECT_GT(state.step, 0);
  EXPECT_EQ(names_in(folder_ / "out/frames").size(), static_cast<std::size_t>(state.step) + 1);
  EXPECT_EQ(read_all(folder_ / "out/steps.csv").find("nan"), std::string::npos);
}

TEST_F(Record, AFullDiskEndsTheRunAndKeepsWhatIsThere) {
  ASSERT_EQ(record(with(options("out"), "time.seconds", "0.2")), exit_done);
  const std::string frame = read_all(folder_ / "out/frames/frame_00002.png");
  std::filesystem::create_symlink("/dev/full", folder_ / "out/frames/frame_00003.png.tmp");
  const std::string message = error_of([&] { record(resumed(options("out"))); });
  EXPECT_NE(message.find("frame_00003.png"), std::string::npos) << message;
  EXPECT_NE(message.find("No space left"), std::string::npos) << message;
  EXPECT_TRUE(json_says(folder_ / "out", "\"status\": \"failed\""));
  EXPECT_EQ(read_all(folder_ / "out/frames/frame_00002.png"), frame);
  EXPECT_EQ(read_state_file(folder_ / "out/state.bin").state.step, 4);
  ASSERT_EQ(record(resumed(options("out"))), exit_done);  // once there is room again
}

}  // namespace
}  // namespace app
