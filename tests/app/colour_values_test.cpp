#include "app/colour_values.h"

#include <gtest/gtest.h>

namespace app {
namespace {

TEST(ColourRange, IsRoundAndInAReadableUnit) {
  const Eigen::VectorXd stress = Eigen::VectorXd::LinSpaced(101, 0, 3.7e4);  // Pa
  const ColourRange range = colour_range(sim::Quantity::stress, std::nullopt, stress, 1e6);
  EXPECT_EQ(range.scale.unit, "kPa");
  EXPECT_FLOAT_EQ(range.scale.low, 0);
  EXPECT_FLOAT_EQ(range.scale.high, 50);
  EXPECT_DOUBLE_EQ(range.factor, 1e-3);
}

TEST(ColourRange, TheSceneDecidesWhereItSaysSo) {
  const ColourRange range =
      colour_range(sim::Quantity::stress, std::array{1e6, 7e6}, Eigen::VectorXd::Constant(3, 1e3), 1e6);
  EXPECT_EQ(range.scale.unit, "MPa");
  EXPECT_FLOAT_EQ(range.scale.low, 1);
  EXPECT_FLOAT_EQ(range.scale.high, 7);
}

TEST(ColourRange, RoundingErrorsOfABodyAtRestAreNotColours) {
  const ColourRange range = colour_range(sim::Quantity::stress, std::nullopt, Eigen::VectorXd::Constant(5, 1e-9), 1e6);
  EXPECT_FLOAT_EQ(range.scale.high, 100);  // Pa: a strain of 1e-4
}

TEST(ColourRange, OneSharpCornerDoesNotDecide) {
  Eigen::VectorXd stress = Eigen::VectorXd::Constant(1000, 90);
  stress[17] = 1e9;
  EXPECT_FLOAT_EQ(colour_range(sim::Quantity::stress, std::nullopt, stress, 1).scale.high, 100);
}

TEST(ColourRange, StretchAndJLieAroundOne) {
  const Eigen::VectorXd J{{0.7, 1.0, 1.1}};
  const ColourRange range = colour_range(sim::Quantity::J, std::nullopt, J, 1e6);
  EXPECT_FLOAT_EQ(range.scale.low, 0.5F);
  EXPECT_FLOAT_EQ(range.scale.high, 1.5F);
}

TEST(ColourRange, PlainHasNoValues) {
  EXPECT_FALSE(quantity("plain").has_value());
  EXPECT_EQ(quantity("energy"), sim::Quantity::energy);
}

}  // namespace
}  // namespace app
