#include "app/residuals/expression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace app {
namespace {

long double value(const std::string& text, long double x = 0.5L) {
  return parse_expression(text)(x).value;
}

std::size_t place_of_error(const std::string& text) {
  try {
    parse_expression(text);
  } catch (const ExpressionError& error) {
    return error.at;
  }
  return std::string::npos;
}

TEST(Expression, HasTheUsualPrecedence) {
  EXPECT_EQ(value("1 + 2*3^2"), 19);
  EXPECT_EQ(value("-x^2"), -0.25L);
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("2^-1"), 0.5L);
  EXPECT_EQ(value("8/4/2"), 1);
  EXPECT_EQ(value("5 - 3 - 1"), 1);
  EXPECT_EQ(value("--x"), 0.5L);
  EXPECT_EQ(value("2*-x"), -1);
  EXPECT_EQ(value("(1+x)*2"), 3);
  EXPECT_EQ(value(".5e1"), 5);
}

TEST(Expression, KnowsItsNames) {
  EXPECT_NEAR(value("sin(pi*x) + cos(pi)"), 0, 1e-18);
  EXPECT_NEAR(value("tan(pi/4)"), 1, 1e-18);
  EXPECT_NEAR(value("ln(e^3) + log10(1000) + exp(0)"), 7, 1e-18);
  EXPECT_EQ(value("sqrt(abs(0-4))"), 2);
}

TEST(Expression, CarriesTheSlope) {
  const sim::residual::Function f = parse_expression("exp(x)*(-1 + 5*x + 4*x^2 + x^3)");
  const long double x = 0.7L;
  EXPECT_NEAR(f(x).slope, std::exp(x) * (4 + 13 * x + 7 * x * x + x * x * x), 1e-16);
}

TEST(Expression, TellsWhereItIsWrong) {
  EXPECT_EQ(place_of_error("1 + y"), 4u);
  EXPECT_EQ(place_of_error("sin(x"), 5u);
  EXPECT_EQ(place_of_error("2x"), 1u);
  EXPECT_EQ(place_of_error("(1 + x))"), 7u);
  EXPECT_EQ(place_of_error(""), 0u);
  EXPECT_EQ(place_of_error("1 + "), 4u);
  EXPECT_EQ(place_of_error("1 ** 2"), 3u);
  EXPECT_EQ(place_of_error("sin x"), 4u);
  EXPECT_EQ(place_of_error("x, 1"), 1u);
  EXPECT_EQ(place_of_error("x\xc2\xb2"), 1u);
  EXPECT_EQ(place_of_error("1e99999"), 0u);
}

TEST(Expression, OfAnyDepthDoesNotExhaustTheStack) {
  EXPECT_NE(place_of_error(std::string(100000, '(')), std::string::npos);
  EXPECT_NE(place_of_error(std::string(100000, '-') + "x"), std::string::npos);
  EXPECT_NE(place_of_error("x" + std::string(100000, '^')), std::string::npos);
  std::string sum = "x";
  for (int i = 0; i < 10000; ++i) sum += "+x";
  EXPECT_EQ(value(sum), 5000.5L);
}

}  // namespace
}  // namespace app
