#include "app/picture/colour_values.h"

#include <gtest/gtest.h>

namespace app {
namespace {

using sim::Quantity;

TEST(ColourRange, IsRoundAndInAReadableUnit) {
  const Eigen::VectorXd stress = Eigen::VectorXd::LinSpaced(101, 0, 3.7e4);  // Pa
  const ColourRange range = colour_range(Quantity::stress, {}, reach_of(Quantity::stress, stress));
  EXPECT_EQ(range.scale.unit, "kPa");
  EXPECT_FLOAT_EQ(range.scale.low, 0);
  EXPECT_FLOAT_EQ(range.scale.high, 40);
  EXPECT_DOUBLE_EQ(range.factor, 1e-3);
}

TEST(ColourRange, TheSceneDecidesWhereItSaysSo) {
  Look look;
  look.range = {1e6, 7e6};
  const ColourRange range = colour_range(Quantity::stress, look, 1e3);
  EXPECT_EQ(range.scale.unit, "MPa");
  EXPECT_FLOAT_EQ(range.scale.low, 1);
  EXPECT_FLOAT_EQ(range.scale.high, 7);
}

TEST(ColourRange, OneSharpCornerDoesNotDecide) {
  Eigen::VectorXd stress = Eigen::VectorXd::Constant(1000, 90);
  stress[17] = 1e9;
  EXPECT_DOUBLE_EQ(reach_of(Quantity::stress, stress), 90);
  EXPECT_DOUBLE_EQ(reach_of(Quantity::stress, Eigen::VectorXd()), 0);
}

TEST(ColourRange, StretchAndJLieAroundOne) {
  const Eigen::VectorXd J{{0.7, 1.0, 1.1}};
  const ColourRange range = colour_range(Quantity::J, {}, reach_of(Quantity::J, J));
  EXPECT_FLOAT_EQ(range.scale.low, 0.7F);
  EXPECT_FLOAT_EQ(range.scale.high, 1.3F);
  EXPECT_EQ(range.scale.map, "blue-red");
  Look look;
  look.colour_map = "magma";
  EXPECT_EQ(colour_range(Quantity::J, look, 1).scale.map, "magma");
}

// A beam of 4 m under its weight strains by about rho g L/E; what a scene loads or moves more, strains it more.
TEST(ColourRange, ASceneTellsWhatIsToBeExpected) {
  sim::Scene scene;
  scene.bodies.resize(1);
  sim::Body& body = scene.bodies[0];
  body.mesh.X = Eigen::MatrixXd{{0, 4}, {0, 1}, {0, 1}};
  body.materials = {sim::MaterialSpec{"stable-neo-hookean", 1e6, 0.45, 1000, ""}};
  const double weight = 1000 * 9.81 * 4;
  EXPECT_NEAR(expected_reach(Quantity::stress, scene), weight, 1);
  EXPECT_NEAR(expected_reach(Quantity::stretch, scene), weight / 1e6, 1e-6);
  EXPECT_NEAR(expected_reach(Quantity::energy, scene), weight * weight / 1e6 / 2, 1);
  body.loads.tractions = {{.where = {}, .value = {0, 2e5, 0}}};
  EXPECT_NEAR(expected_reach(Quantity::stress, scene), 2e5, 1);
  body.pins.resize(1);
  body.pins[0].motion = {{.t = 1, .translate = {1.2, 0, 0}}};
  EXPECT_NEAR(expected_reach(Quantity::stretch, scene), 0.3, 1e-9);
  scene.world.gravity.setZero();
  body.loads.tractions.clear();
  body.pins.clear();
  EXPECT_NEAR(expected_reach(Quantity::stress, scene), 100, 1e-9);  // a strain of 1e-4: no rounding errors in colour
}

TEST(ColourRange, PlainHasNoValues) {
  EXPECT_FALSE(quantity("plain").has_value());
  EXPECT_EQ(quantity("energy"), Quantity::energy);
}

}  // namespace
}  // namespace app
