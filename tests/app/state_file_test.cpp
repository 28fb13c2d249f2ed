#include "app/run/state_file.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/app/temporary_folder.h"

namespace app {
namespace {

SavedRun example() {
  SavedRun run;
  run.scene = 0xfedcba9876543210;
  run.totals = {31, 4000000000000, 2, 5, -0.25};
  run.state.step = 12;
  run.state.x = Eigen::VectorXd::LinSpaced(6, -1.0, 1.0 / 3.0);
  run.state.v = Eigen::VectorXd::Constant(6, std::numeric_limits<double>::denorm_min());
  run.state.x_before = -run.state.x;
  run.state.v_before = Eigen::VectorXd::Zero(6);
  run.state.v_before[1] = -0.0;
  run.state.force = Eigen::VectorXd::Constant(6, 2.5);
  run.state.energy_most = -1e300;
  run.state.kinetic_most = 0.1;
  run.state.parts = 3;
  run.state.fastest = Eigen::VectorXd::Constant(6, -0.5);
  run.state.kept = {1, 7, 2, 12, -1, 0.25, 0.5, 60, 3600, 2, run.state.v, run.state.x, run.state.x, run.state.v};
  return run;
}

// With another number in the eight bytes at `place`.
std::string with_count(std::string bytes, std::size_t place, std::uint64_t count) {
  for (std::size_t i = 0; i < 8; ++i) bytes[place + i] = static_cast<char>(count >> (8 * i) & 0xff);
  return bytes;
}

constexpr std::size_t lengths = 8 + 4 + 8 + 4 * 8 + 6 * 8 + 8;  // where the length of x stands

TEST(StateFile, GivesBackEveryBit) {
  const SavedRun run = example();
  const SavedRun again = decode(encode(run), "state.bin");
  EXPECT_EQ(again.scene, run.scene);
  EXPECT_EQ(again.totals.newton, 31);
  EXPECT_EQ(again.totals.linear, 4000000000000);
  EXPECT_EQ(again.totals.not_converged, 2);
  EXPECT_EQ(again.totals.splits, 5);
  EXPECT_EQ(again.totals.min_J, -0.25);
  EXPECT_EQ(again.state.step, 12);
  EXPECT_EQ(again.state.x, run.state.x);
  EXPECT_EQ(encode(again), encode(run));  // the sign of a zero and the smallest numbers too
}

TEST(StateFile, OneStepSchemesHaveNoStepBefore) {
  SavedRun run = example();
  run.state.x_before.resize(0);
  run.state.v_before.resize(0);
  EXPECT_EQ(decode(encode(run), "state.bin").state.x_before.size(), 0);
}

TEST(StateFile, BytesAreLittleEndianAndInTheDocumentedOrder) {
  const std::string bytes = encode(example());
  EXPECT_EQ(bytes.substr(0, 8), "RITZSTAT");
  EXPECT_EQ(bytes.substr(8, 4), std::string("\7\0\0\0", 4));
  EXPECT_EQ(bytes.substr(12, 8), "\x10\x32\x54\x76\x98\xba\xdc\xfe");
  EXPECT_EQ(bytes[lengths], 6);
  EXPECT_EQ(bytes.size(), lengths + 10 * (8 + 6 * 8) + 3 * 8 + 5 * 8 + 5 * 8 + 8);
}

TEST(StateFile, TruncationAtEveryByteIsNoticed) {
  const std::string bytes = encode(example());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const std::string message = error_of([&] { decode(std::string_view(bytes).substr(0, length), "run/state.bin"); });
    EXPECT_EQ(message.find("run/state.bin: the saved state"), 0U) << "length " << length << ": " << message;
  }
  EXPECT_NE(error_of([&] { decode(bytes + '\0', "state.bin"); }), "");
}

TEST(StateFile, EveryFlippedBitIsNoticed) {
  const std::string bytes = encode(example());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    EXPECT_THROW(decode(damaged, "state.bin"), std::runtime_error) << "bit " << bit;
  }
}

TEST(StateFile, AbsurdLengthsAreRefusedBeforeAnythingIsAllocated) {
  const std::string bytes = encode(example());
  for (const std::uint64_t length : {std::uint64_t{1} << 31, std::uint64_t{1000000000000000000}, ~std::uint64_t{0}}) {
    for (std::size_t vector = 0; vector < 4; ++vector) {
      const std::string damaged = with_count(bytes, lengths + (8 + 6 * 8) * vector, length);
      EXPECT_NE(error_of([&] { decode(damaged, "state.bin"); }).find("cut short"), std::string::npos);
    }
  }
}

TEST(StateFile, OtherVersionsAndOtherFilesAreNamedAsSuch) {
  std::string newer = encode(example());
  newer[8] = 9;
  EXPECT_NE(error_of([&] { decode(newer, "state.bin"); }).find("has version 9, this program reads 7 and 8"),
            std::string::npos);
  EXPECT_NE(error_of([] { decode("\x89PNG and something else", "state.bin"); }).find("not a state file"),
            std::string::npos);
}

TEST(StateFile, NumbersThatNoRunLeavesAreRefused) {
  SavedRun run = example();
  run.state.x[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(decode(encode(run), "state.bin"), std::runtime_error);
  run = example();
  run.state.v.conservativeResize(5);
  EXPECT_THROW(decode(encode(run), "state.bin"), std::runtime_error);
  run = example();
  run.state.step = -1;
  EXPECT_THROW(decode(encode(run), "state.bin"), std::runtime_error);
}

TEST(StateFile, WritingReplacesTheFileAndLeavesNothingBeside) {
  const TemporaryFolder folder;
  SavedRun run = example();
  write_state_file(folder / "state.bin", run);
  run.state.step = 13;
  write_state_file(folder / "state.bin", run);
  EXPECT_EQ(read_state_file(folder / "state.bin").state.step, 13);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(StateFile, MissingFileIsNamed) {
  EXPECT_EQ(error_of([] { read_state_file("/nowhere/state.bin"); }), "/nowhere/state.bin: no saved state there");
}

}  // namespace
}  // namespace app
