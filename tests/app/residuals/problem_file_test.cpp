#include "app/residuals/problem_file.h"

#include <gtest/gtest.h>

#include "tests/app/temporary_folder.h"

namespace app {
namespace {

std::string error_in(const std::string& text) {
  return error_of([&] { read_problem(text, "p.toml"); });
}

void expect_error(const std::string& text, const std::string& begin, const std::string& part) {
  const std::string message = error_in(text);
  EXPECT_TRUE(message.starts_with(begin)) << message;
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(ProblemFile, HasDefaults) {
  const ProblemFile file = read_problem("f = \"1\"", "some/where/unit.load.toml");
  EXPECT_EQ(file.name, "unit.load");
  EXPECT_EQ(file.bases.size(), 3u);
  EXPECT_EQ(file.methods.size(), 5u);
  EXPECT_EQ(file.n, (std::vector<int>{1, 2, 4, 8, 16, 32}));
  EXPECT_TRUE(file.exact_is_computed());
  EXPECT_NEAR(file.problem.exact(0.5L).value, 0.125, 1e-18);  // x (1 - x)/2
}

TEST(ProblemFile, ReadsItsLists) {
  const ProblemFile file =
      read_problem("f = \"1\"\nbases = [\"hats\"]\nmethods = [\"ritz\", \"galerkin\"]\nn = [4, 2, 4]", "p.toml");
  ASSERT_EQ(file.bases.size(), 1u);
  EXPECT_EQ(file.bases[0]->name, "hats");
  ASSERT_EQ(file.methods.size(), 2u);
  EXPECT_EQ(file.methods[0]->name, "ritz");
  EXPECT_EQ(file.n, (std::vector<int>{2, 4}));
}

TEST(ProblemFile, TellsLineAndColumnOfAWrongExpression) {
  expect_error("k = \"1\"\nf   = \"1 + y\"", "p.toml:2:12: f = \"1 + y\"", "unknown name 'y'");
  expect_error("f = 'sin(x'", "p.toml:1:11:", "')' is missing, at character 6");
  expect_error("f = \"\"", "p.toml:1:6:", "missing at the end");
  expect_error("f = \"\"\"\n1 + y\"\"\"", "p.toml:1:5:", "at character 5");
  expect_error("f = 1", "p.toml:1:", "in quotes");
  // Of a long expression what is about the mistake.
  std::string long_sum;
  for (int i = 0; i < 10000; ++i) long_sum += "1+";
  const std::string long_text = error_in("f = \"" + long_sum + "y+" + long_sum + "1\"");
  EXPECT_LT(long_text.size(), 250u);
  EXPECT_TRUE(long_text.starts_with("p.toml:1:20006: f = \"...")) << long_text;
}

TEST(ProblemFile, RefusesWhatItDoesNotKnow) {
  expect_error("f = \"1\"\nexcat = \"0\"", "p.toml:2:", "did you mean 'exact'?");
  expect_error("f = \"1\"\nbases = [\"cosines\"]", "p.toml:2:", "must be one of sines, polynomials, hats");
  expect_error("f = \"1\"\nmethods = [3]", "p.toml:2: methods: '3' is not a method", "must be one of collocation");
  expect_error("f = \"1\"\nmethods = \"galerkin\"", "p.toml:2:", "must be a list");
  expect_error("f = \"1\"\nmethods = []", "p.toml:2:", "must be a list");
  expect_error("k = \"1\"", "p.toml", "f is missing");
  expect_error("f = ", "p.toml:1:", "");
  expect_error("", "p.toml", "f is missing");
}

TEST(ProblemFile, RefusesNumbersOfTermsOutOfRange) {
  for (const char* const n : {"[0]", "[10000]", "[-1]", "4", "[]", "[1.5]", "[\"4\"]", "[[4]]"})
    expect_error("f = \"1\"\nn = " + std::string(n), "p.toml:2:", "integers from 1 to 256");
}

TEST(ProblemFile, RefusesProblemsThatCannotBeSolved) {
  expect_error("f = \"1/0\"", "p.toml:1:", "f(0.001) = inf");
  expect_error("f = \"sqrt(0-1)\"", "p.toml:1:", "must be a number below");
  expect_error("f = \"1/(x-0.5)\"", "p.toml:1:", "f(0.5) =");
  expect_error("f = \"1/(x-1/3)\"", "p.toml:1:", "must be bounded");
  expect_error("f = \"1\"\nk = \"x - 0.5\"", "p.toml:2:", "k(0) = -0.5: must be > 0");
  expect_error("f = \"1\"\nk = \"x\"", "p.toml:2:", "k(0) = 0: must be > 0");
  expect_error("f = \"1\"\nq = \"-pi^2\"", "p.toml:1:", "no solution that is the only one");
  expect_error("f = \"exp(1000)\"", "p.toml:1:", "f(0.001) = 1.97007e+434: must be a number below 1e100");
  expect_error("f = \"sin(1e7*x)\"", "p.toml:1:", "must not swing so fast");
}

TEST(ProblemFile, RefusesAnExactSolutionThatIsNone) {
  expect_error("f = \"1\"\nexact = \"x*(1-x)\"", "p.toml:2:", "must be the solution, which is 0.125 there");
  expect_error("f = \"1\"\nexact = \"x*(2-x)/2\"", "p.toml:2:", "must be 0 at x = 0 and x = 1");
  EXPECT_EQ(error_in("f = \"1\"\nexact = \"x*(1-x)/2\""), "");
}

TEST(ProblemFile, TellsThatAFileCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_NE(error_of([&] { read_problem(folder / "none.toml"); }).find("there is no such file"), std::string::npos);
  EXPECT_NE(error_of([&] { read_problem(folder.path()); }).find("cannot be read"), std::string::npos);
  write_all(folder / "empty.toml", "");
  EXPECT_NE(error_of([&] { read_problem(folder / "empty.toml"); }).find("f is missing"), std::string::npos);
}

}  // namespace
}  // namespace app
