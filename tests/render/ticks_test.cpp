#include "render/ticks.h"

#include <gtest/gtest.h>

namespace {

using Labels = std::vector<std::string>;

TEST(Ticks, AreRoundAndInside) {
  EXPECT_EQ(render::ticks(0, 1, 5).size(), 6U);
  EXPECT_EQ(render::tick_labels(render::ticks(0, 1, 5)), (Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(render::tick_labels(render::ticks(-0.3, 0.4, 3)), (Labels{"-0.2", "0.0", "0.2", "0.4"}));
  EXPECT_EQ(render::tick_labels(render::ticks(3, 41, 4)), (Labels{"5", "10", "15", "20", "25", "30", "35", "40"}));
}

TEST(Ticks, AreNeverTooMany) {
  for (double low : {-7.0, 0.0, 1e-9, 1e6}) {
    for (double width : {1e-6, 0.37, 1.0, 6.9, 1e5}) {
      for (int wanted : {1, 3, 10}) {
        const std::vector<double> values = render::ticks(low, low + width, wanted);
        EXPECT_LE(values.size(), 2.5 * wanted + 1) << low << " " << width << " " << wanted;
        for (const double value : values) {
          EXPECT_GE(value, low - 1e-5 * width);
          EXPECT_LE(value, low + width * (1 + 1e-5));
        }
      }
    }
  }
}

TEST(Ticks, EmptyRangeGivesItsNumber) {
  EXPECT_EQ(render::ticks(3, 3, 5), (std::vector<double>{3}));
  EXPECT_EQ(render::ticks(0, 0, 5), (std::vector<double>{0}));
}

TEST(Ticks, LargeAndSmallNumbersHaveExponents) {
  EXPECT_EQ(render::tick_labels({0, 1e6, 2e6}), (Labels{"0", "1e+06", "2e+06"}));
  EXPECT_EQ(render::tick_labels({0, 2e-5}), (Labels{"0", "2e-05"}));
}

TEST(Ticks, NumbersFarFromZeroAreCountedFromARoundOne) {
  EXPECT_EQ(render::tick_offset({408200, 408201, 408202}), 408200);
  EXPECT_EQ(render::tick_offset({-408202, -408201, -408200}), -408210);
  EXPECT_EQ(render::tick_offset({0, 1, 2}), 0);
  EXPECT_EQ(render::tick_offset({1000, 1001}), 0);
  EXPECT_EQ(render::tick_offset({5e6}), 0);
}

TEST(Ticks, RoundLengths) {
  EXPECT_DOUBLE_EQ(render::round_length(1), 1);
  EXPECT_DOUBLE_EQ(render::round_length(4.9), 2);
  EXPECT_DOUBLE_EQ(render::round_length(0.0099), 0.005);
  EXPECT_DOUBLE_EQ(render::round_length(1000), 1000);
}

}  // namespace
