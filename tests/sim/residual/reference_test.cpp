// The weighted residual methods against tables made with 40 digits.
#include <gtest/gtest.h>

#include <map>

#include "sim/residual/errors.h"
#include "sim/residual/method.h"
#include "tests/sim/residual/problems.h"

namespace sim::residual {
namespace {

const Method& method_named(const std::string& name) {
  return *find_method(name == "ritz-anyway" ? "ritz" : name);
}

// The table has 10 digits.
void expect_equal(Real found, const std::string& expected, const std::string& what) {
  const Real number = std::stold(expected);
  EXPECT_LE(std::abs(found - number), 1e-8L * std::abs(number)) << what << ": " << found << " and " << expected;
}

TEST(Residuals, ErrorsAreThoseOfTheTable) {
  const auto rows = test::rows_of("residuals.csv");
  ASSERT_EQ(rows.size(), 180u);
  for (const auto& row : rows) {
    const std::string what = row[0] + " " + row[1] + " " + row[2] + " " + row[3];
    const Problem problem = test::problem_named(row[0]);
    const Basis& basis = *find_basis(row[1]);
    const Answer answer = method_named(row[2]).solve(problem, basis, std::stoi(row[3]));
    ASSERT_EQ(answer.refusal, "") << what;
    const Errors errors = measure(problem, Trial(basis, answer.c), asymmetry(problem).power == 0);
    expect_equal(errors.L2, row[4], what + " L2");
    expect_equal(errors.H1_seminorm, row[5], what + " H1");
    EXPECT_EQ(errors.energy_norm.has_value(), !row[6].empty()) << what;
    if (errors.energy_norm) expect_equal(*errors.energy_norm, row[6], what + " energy");
    EXPECT_EQ(errors.residual_L2.has_value(), !row[7].empty()) << what;
    if (errors.residual_L2) expect_equal(*errors.residual_L2, row[7], what + " residual");
    expect_equal(errors.max_1001, row[8], what + " max");
    EXPECT_EQ(errors.F.has_value(), !row[9].empty()) << what;
    if (errors.F) expect_equal(*errors.F, row[9], what + " F");
  }
}

TEST(Residuals, CoefficientsAreThoseOfTheTable) {
  const auto rows = test::rows_of("residual_coefficients.csv");
  ASSERT_EQ(rows.size(), 960u);
  std::map<std::string, Vector> known;
  for (const auto& row : rows) {
    const std::string what = row[0] + " " + row[1] + " " + row[2] + " " + row[3];
    Vector& c = known[what];
    if (c.size() == 0) {
      const Basis& basis = *find_basis(row[1].substr(0, row[1].find(':')));
      c = method_named(row[2]).solve(test::problem_named(row[0]), basis, std::stoi(row[3])).c;
      if (row[1].ends_with("x^i(1-x)")) c = to_monomials(c);
    }
    expect_equal(c[std::stoi(row[4]) - 1], row[5], what + " c" + row[4]);
  }
}

// The table has them with two decimals.
TEST(Residuals, OrdersAreThoseOfTheTable) {
  const auto rows = test::rows_of("residual_orders.csv");
  ASSERT_EQ(rows.size(), 8u);
  for (const auto& row : rows) {
    const std::string what = row[0] + " " + row[1] + " " + row[2];
    const Problem problem = test::problem_named(row[0]);
    const Basis& basis = *find_basis(row[1]);
    const auto errors = [&](int n) {
      return measure(problem, Trial(basis, method_named(row[2]).solve(problem, basis, n).c), true);
    };
    const Errors coarse = errors(16), fine = errors(32);
    EXPECT_NEAR(order(basis, 16, coarse.L2, 32, fine.L2), std::stod(row[4]), 0.005) << what;
    EXPECT_NEAR(order(basis, 16, coarse.H1_seminorm, 32, fine.H1_seminorm), std::stod(row[5]), 0.005) << what;
    if (!row[6].empty()) {
      EXPECT_NEAR(order(basis, 16, *coarse.residual_L2, 32, *fine.residual_L2), std::stod(row[6]), 0.005) << what;
    }
    EXPECT_NEAR(order(basis, 16, coarse.max_1001, 32, fine.max_1001), std::stod(row[7]), 0.005) << what;
  }
}

}  // namespace
}  // namespace sim::residual
