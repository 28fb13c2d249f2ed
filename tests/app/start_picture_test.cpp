// What is said of contacts while a scene runs, and the picture of a start that is refused.
#include <gtest/gtest.h>

#include "app/command/commands.h"
#include "app/run/contact_totals.h"
#include "app/scene/crossed_start.h"
#include "tests/app/temporary_folder.h"

namespace app {
namespace {

// Two blocks on each other, the upper one so high; beside them an obstacle that is a surface.
std::string blocks(const std::string& height) {
  return "[time]\nseconds = 0.1\n[[body]]\nname = \"low\"\nmesh = { box = [1, 1, 1], cells = [2, 2, 2] }\n"
         "[[body]]\nname = \"top\"\nmesh = { box = [1, 1, 1], cells = [2, 2, 2], translate = [0, " +
         height + ", 0] }\n[[obstacle]]\nbox = [[-1, -1, -1], [2, -0.5, 2]]\n[[contact]]\n";
}

class StartPicture : public ::testing::Test {
 protected:
  Options still_of(const std::string& height) {
    std::ofstream(folder_ / "blocks.toml") << blocks(height);
    Options options;
    options.scene = folder_ / "blocks.toml";
    options.out = folder_ / ("out" + height);
    options.width = 96;
    options.height = 72;
    options.still = options.quiet = true;
    return options;
  }
  std::filesystem::path frame_of(const Options& options) { return options.out / "frames" / "frame_00000.png"; }
  TemporaryFolder folder_;
};

TEST_F(StartPicture, IsDrawnWhereBodiesCrossOrTouch) {
  for (const char* height : {"0.9", "1"}) {
    const Options options = still_of(height);
    try {
      record(options);
      FAIL() << height;
    } catch (const CrossedStart& error) {
      EXPECT_NE(std::string(error.what()).find("blocks.toml:11: contact.0: \"low\" and \"top\" "), std::string::npos)
          << error.what();
      EXPECT_GT(error.places.size(), 3U);
    }
    EXPECT_TRUE(std::filesystem::exists(frame_of(options))) << height;
  }
}

TEST_F(StartPicture, IsNotDrawnWhereTheyAreApartOrNoStillIsAskedFor) {
  const Options apart = still_of("1.01");
  EXPECT_EQ(record(apart), 0);
  EXPECT_FALSE(std::filesystem::exists(frame_of(apart)));
  Options moving = still_of("0.9");
  moving.still = false;
  EXPECT_THROW(record(moving), CrossedStart);
  EXPECT_FALSE(std::filesystem::exists(frame_of(moving)));
}

TEST(ContactTotals, AreSaidInAFewWords) {
  sim::ContactReport one, other;
  one.pairs = 3;
  one.gap = 2e-4;
  other.pairs = 31;
  other.gap = 2.14e-5;
  EXPECT_EQ(contact_text(totals_of({one, other})), "34 contacts, least gap 2.1e-05 m");
  EXPECT_EQ(contact_text(totals_of({sim::ContactReport{}})), "0 contacts");
}

}  // namespace
}  // namespace app
