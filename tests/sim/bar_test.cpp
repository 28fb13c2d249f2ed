// The bar of the lecture against its tables: frequencies and step limits, of formulas and of strips of quadrilaterals.
#include "sim/study/bar.h"

#include <fstream>
#include <sstream>

#include "sim/study/explicit_limit.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

constexpr double digits = 1e-8;

std::vector<std::vector<double>> rows_of(const std::string& name) {
  std::ifstream file(std::string(RITZ_SOURCE_DIR) + "/tests/data/lecture/" + name);
  std::vector<std::vector<double>> rows;
  std::string line;
  for (std::getline(file, line); std::getline(file, line);) {
    std::istringstream stream(line);
    rows.emplace_back();
    for (std::string cell; std::getline(stream, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

// A strip of quadrilaterals, one cell high, that is the bar of a row of both tables: L,E,rho,n,...
Scene strip_of(const std::vector<double>& row, double height, MassMatrix mass) {
  Scene scene;
  scene.dimension = 2;
  Body body;
  body.mesh = generate_rectangle({row[0], height}, {static_cast<int>(row[3]), 1}, {1, 1}, ElementKind::quad4);
  body.materials = {MaterialSpec{"linear", row[1], 0, row[2], ""}};
  body.pins = {Pin{InGroup{"left"}, "xy", {}, {}, false}, Pin{Box{{-1, -1, -1}, {9, 1, 1}}, "y", {}, {}, false}};
  body.mass = mass;
  scene.bodies = {body};
  return scene;
}

// bar_frequencies.csv: L,E,rho,n,mode,exact_Hz,consistent_Hz,lumped_Hz,...
TEST(LectureBar, BarsRingAsTheirFormulasSay) {
  constexpr double two_pi = 6.283185307179586;
  const auto rows = rows_of("bar_frequencies.csv");
  ASSERT_GE(rows.size(), 28u);
  Eigen::VectorXd of_strip[2];
  int cells = 0;
  for (const std::vector<double>& v : rows) {
    const int n = static_cast<int>(v[3]), k = static_cast<int>(v[4]);
    const BarFrequencies bar = bar_frequencies(v[0], v[1], v[2], n, k);
    EXPECT_NEAR(bar.exact / two_pi / v[5], 1, digits) << n << " " << k;
    EXPECT_NEAR(bar.consistent / two_pi / v[6], 1, digits) << n << " " << k;
    EXPECT_NEAR(bar.lumped / two_pi / v[7], 1, digits) << n << " " << k;
    if (n != cells) {
      cells = n;
      for (const MassMatrix mass : {MassMatrix::consistent, MassMatrix::lumped})
        of_strip[mass == MassMatrix::lumped] = bar_modes(strip_of(v, 0.1, mass), 0, n).omega / two_pi;
    }
    ASSERT_EQ(of_strip[0].size(), n);
    EXPECT_NEAR(of_strip[0][k - 1] / v[6], 1, digits) << n << " " << k;
    EXPECT_NEAR(of_strip[1][k - 1] / v[7], 1, digits) << n << " " << k;
  }
}

// bar_limits.csv: L,E,rho,n,wave_speed,omega_max_consistent,omega_max_lumped,h_critical_consistent,h_critical_lumped,
// ratio,two bounds of an element,strip_omega_max_consistent,strip_omega_max_lumped
TEST(LectureBar, StepLimitsOfBarsAreThoseOfTheirFastestModes) {
  const auto rows = rows_of("bar_limits.csv");
  ASSERT_EQ(rows.size(), 3u);
  for (const std::vector<double>& v : rows) {
    const int n = static_cast<int>(v[3]);
    const BarFrequencies fastest = bar_frequencies(v[0], v[1], v[2], n, n);
    EXPECT_NEAR(fastest.consistent / v[5], 1, digits) << n;
    EXPECT_NEAR(fastest.lumped / v[6], 1, digits) << n;
    EXPECT_NEAR(2 / fastest.consistent / v[7], 1, digits) << n;
    EXPECT_NEAR(2 / fastest.lumped / v[8], 1, digits) << n;
    EXPECT_NEAR(fastest.lumped / fastest.consistent / v[9], 1, digits) << n;
    for (const MassMatrix mass : {MassMatrix::consistent, MassMatrix::lumped}) {
      const Scene scene = strip_of(v, v[0] / n, mass);  // of square cells
      const double limit = 2 / v[mass == MassMatrix::consistent ? 12 : 13],
                   found = explicit_limit(scene, System(scene), 1);
      EXPECT_LE(found, limit) << n;
      EXPECT_GE(found, 0.97 * limit) << n;
    }
  }
}

}  // namespace
}  // namespace sim
