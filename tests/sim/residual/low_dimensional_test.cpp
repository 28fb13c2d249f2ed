// A chain of 200 springs in five vectors.
#include "sim/residual/low_dimensional.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <fstream>
#include <sstream>
#include <string>

namespace sim::residual {
namespace {

Chain lecture_chain(double wind) {
  return make_chain(
      200, [](double s) { return 1 + 10 * s * s; }, [](double s) { return s >= 0.6 && s <= 0.7 ? 21.0 : 1.0; }, wind);
}

// The part of the file from a name in quotes on.
std::string from(const std::string& text, const std::string& name) {
  const std::size_t at = text.find("\"" + name + "\":");
  EXPECT_NE(at, std::string::npos) << name;
  return text.substr(at + name.size() + 3);
}

std::string section(const std::string& name) {
  std::ifstream file(std::string(RITZ_SOURCE_DIR) + "/tests/data/lecture/low_dimensional.json");
  std::ostringstream text;
  text << file.rdbuf();
  return from(text.str(), name);
}

double number(const std::string& text, const std::string& name) {
  return std::stod(from(text, name));
}

// The five numbers after "c".
Eigen::VectorXd coefficients(const std::string& text) {
  std::string list = from(text, "c");
  for (char& c : list)
    if (c == '[' || c == ',') c = ' ';
  std::istringstream numbers(list);
  Eigen::VectorXd c(5);
  for (double& entry : c) numbers >> entry;
  return c;
}

// All numbers of an entry; c to 1e-8 of its largest.
void expect_entry(const std::string& text, const std::string& name, const Chain& chain, const Eigen::MatrixXd& U,
                  const Eigen::VectorXd& c) {
  const std::string entry = from(text, name);
  const Eigen::VectorXd expected = coefficients(entry);
  EXPECT_LT((c - expected).cwiseAbs().maxCoeff(), 1e-8 * expected.cwiseAbs().maxCoeff()) << name;
  const ChainErrors errors = measure(chain, solve(chain), U * c);
  EXPECT_NEAR(errors.residual / number(entry, "residual_2"), 1, 1e-8) << name;
  EXPECT_NEAR(errors.energy / number(entry, "energy"), 1, 1e-8) << name;
  EXPECT_NEAR(errors.distance / number(entry, "error_2"), 1, 1e-8) << name;
  EXPECT_NEAR(errors.largest / number(entry, "error_max"), 1, 1e-8) << name;
}

const char* const projection_method = "best in the 2-norm (projection of the solution)";

TEST(LowDimensional, TheFiveVectorsOfTheTable) {
  const std::string text = section("symmetric");
  const Chain chain = lecture_chain(0);
  const Eigen::MatrixXd U = power_vectors(chain, 5);
  expect_entry(text, "a rows equally spaced", chain, U, solve_rows(chain, U, equal_rows(200, 5)));
  const std::vector<int> pivoted = pivoted_rows(matrix(chain) * U);
  EXPECT_EQ(pivoted, (std::vector<int>{0, 63, 108, 163, 199}));
  expect_entry(text, "a rows by pivoted QR of (AU)^T", chain, U, solve_rows(chain, U, pivoted));
  expect_entry(text, "b least squares", chain, U, solve_least_squares(chain, U));
  expect_entry(text, "c Galerkin", chain, U, solve_galerkin(chain, U));
  expect_entry(text, "d energy", chain, U, solve_energy(chain, U));
  expect_entry(text, projection_method, chain, U, project(solve(chain), U));
  EXPECT_NEAR(chain.b.norm() / 94.86832981, 1, 1e-8);
  EXPECT_NEAR(solve(chain).norm() / 1.112668262, 1, 1e-8);
}

// The first five rows are nearly the same: their condition is 1e10, and the table, made in double precision, has six
// digits of them. The numbers here are those of rational arithmetic.
TEST(LowDimensional, TheFirstRowsAreTheWorstChoice) {
  const Chain chain = lecture_chain(0);
  const Eigen::MatrixXd U = power_vectors(chain, 5);
  const Eigen::VectorXd c = solve_rows(chain, U, first_rows(5));
  const double exact[] = {3.7782881588848243, 3.2782545196185238, -9.316838007968776, -6.862111090065261,
                          70.937371931758};
  const Eigen::VectorXd table = coefficients(from(section("symmetric"), "a rows first five"));
  for (int j = 0; j < 5; ++j) {
    EXPECT_NEAR(c[j] / exact[j], 1, 1e-5) << j;  // the five rows are nearly dependent
    EXPECT_NEAR(table[j] / exact[j], 1, 1e-6) << j;
  }
  EXPECT_NEAR(measure(chain, solve(chain), U * c).residual / 25451.72125, 1, 1e-5);
}

TEST(LowDimensional, SinesOfTheTable) {
  const std::string text = section("symmetric, basis sin(j pi s)");
  const Chain chain = lecture_chain(0);
  const Eigen::MatrixXd U = sine_vectors(chain, 5);
  expect_entry(text, "a rows equally spaced", chain, U, solve_rows(chain, U, equal_rows(200, 5)));
  expect_entry(text, "b least squares", chain, U, solve_least_squares(chain, U));
  expect_entry(text, "c Galerkin", chain, U, solve_galerkin(chain, U));
  expect_entry(text, "d energy", chain, U, solve_energy(chain, U));
  expect_entry(text, projection_method, chain, U, project(solve(chain), U));
}

TEST(LowDimensional, AWindThatTheEnergyDoesNotSee) {
  const std::string text = section("not symmetric: A + 30 central difference");
  const Chain chain = lecture_chain(30);
  const Eigen::MatrixXd U = power_vectors(chain, 5);
  expect_entry(text, "a rows equally spaced", chain, U, solve_rows(chain, U, equal_rows(200, 5)));
  expect_entry(text, "b least squares", chain, U, solve_least_squares(chain, U));
  expect_entry(text, "c Galerkin", chain, U, solve_galerkin(chain, U));
  expect_entry(text, "d energy of the symmetric part (wrong)", chain, U, solve_energy(chain, U));
  expect_entry(text, projection_method, chain, U, project(solve(chain), U));
}

TEST(LowDimensional, EachMethodIsLeastInItsOwnNorm) {
  const Chain chain = lecture_chain(0);
  const Eigen::MatrixXd U = power_vectors(chain, 4);
  const Eigen::VectorXd x = solve(chain), squares = solve_least_squares(chain, U), energy = solve_energy(chain, U),
                        nearest = project(x, U);
  EXPECT_LT((solve_galerkin(chain, U) - energy).cwiseAbs().maxCoeff(), 1e-9 * energy.cwiseAbs().maxCoeff());
  for (int j = 0; j < 4; ++j)
    for (const double step : {-1e-3, 1e-3}) {
      const Eigen::VectorXd aside = step * Eigen::VectorXd::Unit(4, j);
      EXPECT_GT(measure(chain, x, U * (squares + aside)).residual, measure(chain, x, U * squares).residual);
      EXPECT_GT(measure(chain, x, U * (energy + aside)).energy, measure(chain, x, U * energy).energy);
      EXPECT_GT(measure(chain, x, U * (nearest + aside)).distance, measure(chain, x, U * nearest).distance);
    }
}

TEST(LowDimensional, TheMatrixIsThatOfTheSprings) {
  const Chain chain = lecture_chain(0);
  const Eigen::VectorXd x = Eigen::VectorXd::Random(200);
  EXPECT_NEAR(x.dot(matrix(chain) * x) / chain.springs.dot(stretches(x).cwiseAbs2().col(0)), 1, 1e-12);
  const Eigen::MatrixXd wind = matrix(lecture_chain(30)) - matrix(chain);
  EXPECT_LT((wind + wind.transpose()).norm(), 1e-9);
}

}  // namespace
}  // namespace sim::residual
