#include "app/base/progress.h"

#include <gtest/gtest.h>

#include <sstream>

namespace app {
namespace {

using Clock = Progress::Clock;
const Clock::time_point start{};

Clock::time_point after(double seconds) {
  return start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

TEST(Progress, LinesComeEveryThreeSeconds) {
  std::ostringstream out;
  Progress progress(out, ProgressStyle::lines, {0, 300, 1.0 / 60}, start);
  for (int step = 1; step <= 75; ++step) progress.update(step, after(0.1 * step));  // 7.5 s
  EXPECT_EQ(out.str(),
            "step 30/300, t = 0.50 s, 0.17 times real time, 0:27 left\n"
            "step 60/300, t = 1.00 s, 0.17 times real time, 0:24 left\n");
}

TEST(Progress, AResumedRunCountsOnlyItsOwnSteps) {
  std::ostringstream out;
  Progress progress(out, ProgressStyle::lines, {200, 300, 0.01}, start);
  progress.update(250, after(5));
  EXPECT_EQ(out.str(), "step 250/300, t = 2.50 s, 0.10 times real time, 0:05 left\n");
  progress.finish(300, after(10));
  EXPECT_NE(out.str().find("100 steps, 1 s simulated in 10 s: 0.10 times real time\n"), std::string::npos) << out.str();
}

TEST(Progress, ABarStaysOnItsLine) {
  std::ostringstream out;
  Progress progress(out, ProgressStyle::bar, {0, 2, 0.5}, start);
  progress.update(1, after(0.5));
  EXPECT_EQ(out.str().find("\r[############............] step 1/2"), 0U) << out.str();
  EXPECT_EQ(out.str().find('\n'), std::string::npos);
}

TEST(Progress, SilentSaysNothing) {
  std::ostringstream out;
  Progress progress(out, ProgressStyle::silent, {0, 2, 0.5}, start);
  progress.update(1, after(50));
  progress.finish(2, after(100));
  EXPECT_EQ(out.str(), "");
}

TEST(Progress, ClockText) {
  EXPECT_EQ(clock_text(65.4), "1:05");
  EXPECT_EQ(clock_text(7389), "2:03:09");
}

}  // namespace
}  // namespace app
