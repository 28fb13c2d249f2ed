// Computed solutions, and problems that have none.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/residual/errors.h"
#include "sim/residual/grid.h"
#include "sim/residual/method.h"
#include "sim/residual/reference.h"
#include "tests/sim/residual/problems.h"

namespace sim::residual {
namespace {

using test::constant;

std::string key_of_error(const std::function<void()>& call) {
  try {
    call();
  } catch (const ProblemError& error) {
    return error.key;
  }
  return "";
}

TEST(ComputedSolution, IsTheExactOne) {
  for (const char* const name : {"A", "B", "C0.1", "C0.01"}) {
    const Problem problem = test::problem_named(name);
    const Reference reference = compute_reference(problem);
    EXPECT_LT(reference.change, 1e-15L) << name;
    for (int i = 0; i <= 100; ++i) {
      const Real x = Real(i) / 100;
      const Jet u = problem.exact(x), found = reference.u(x);
      EXPECT_NEAR(found.value, u.value, 1e-15) << name << x;
      EXPECT_NEAR(found.slope, u.slope, 1e-11) << name << x;
    }
  }
}

TEST(ComputedSolution, OfAKinkAndOfASteepLayer) {
  // -(k u')' = 1 with k = 1 + |x - 0.3|: u' = (c - x)/k, and u(1) = 0 gives c.
  Problem kink{[](Real x) {
                 return Jet{1 + std::abs(x - 0.3L), x < 0.3L ? -1.0L : 1.0L};
               },
               constant(0), constant(0), constant(1), nullptr};
  const Reference reference = compute_reference(kink);
  const Real c = reference.u(0.1L).slope * 1.2L + 0.1L;
  for (const Real x : {0.2L, 0.5L, 0.9L}) EXPECT_NEAR(reference.u(x).slope * kink.k(x).value + x, c, 1e-9);
  EXPECT_NEAR(reference.u(1).value, 0, 1e-15);

  const Problem layer = test::problem_c(1e-4L);
  const Reference steep = compute_reference(layer);
  for (const Real x : {0.5L, 0.999L, 0.9999L, 0.99999L}) EXPECT_NEAR(steep.u(x).value, layer.exact(x).value, 1e-12);
}

TEST(ComputedSolution, ServesAsTheExactOneInTheErrors) {
  Problem problem = test::problem_c(0.01L);
  const Trial u(*find_basis("hats"), galerkin(problem, *find_basis("hats"), 8).c);
  const Errors exact = measure(problem, u, false);
  problem.exact = compute_reference(problem).u;
  const Errors computed = measure(problem, u, false);
  EXPECT_NEAR(computed.L2 / exact.L2, 1, 1e-10);
  EXPECT_NEAR(computed.H1_seminorm / exact.H1_seminorm, 1, 1e-10);
}

TEST(ComputedSolution, IsRefusedAtAnEigenvalue) {
  Problem problem = test::problem_a();
  const Real pi = std::numbers::pi_v<Real>;
  problem.q = constant(-pi * pi);
  EXPECT_EQ(key_of_error([&] { compute_reference(problem); }), "f");
}

TEST(Problems, ThatCannotBeSolvedNameTheFunctionAtFault) {
  Problem problem = test::problem_a();
  problem.k = [](Real x) { return Jet{x - 0.5L, 1}; };
  EXPECT_EQ(key_of_error([&] { check(problem); }), "k");
  problem.k = constant(0);
  EXPECT_EQ(key_of_error([&] { check(problem); }), "k");
  problem = test::problem_a();
  problem.f = constant(INFINITY);
  EXPECT_EQ(key_of_error([&] { check(problem); }), "f");
  problem.f = constant(NAN);
  EXPECT_EQ(key_of_error([&] { check(problem); }), "f");
  problem = test::problem_a();
  problem.exact = constant(1);
  EXPECT_EQ(key_of_error([&] { check(problem); }), "exact");
  problem = test::problem_a();
  problem.f = [](Real x) { return Jet{1 / (x - 1 / 3.0L), 0}; };
  EXPECT_EQ(key_of_error([&] { make_panels(problem, 4); }), "f");
  problem.f = [](Real x) { return Jet{std::sin(1e7L * x), 0}; };
  EXPECT_EQ(key_of_error([&] { make_panels(problem, 4); }), "f");
}

TEST(Panels, AreHalvedAtAKinkAndAtALayerOnly) {
  Problem problem = test::problem_a();
  EXPECT_EQ(make_panels(problem, 4).size(), 11u);
  problem.f = [](Real x) { return Jet{std::abs(x - 0.3L), x < 0.3L ? -1.0L : 1.0L}; };
  const std::vector<Real> ends = make_panels(problem, 3);
  EXPECT_GT(ends.size(), 20u);
  EXPECT_LT(ends.size(), 60u);
  for (std::size_t i = 1; i < ends.size(); ++i)
    EXPECT_TRUE(ends[i] - ends[i - 1] < 0.01L || ends[i] <= 0.3L + 0.13L || ends[i - 1] >= 0.3L) << i;
}

}  // namespace
}  // namespace sim::residual
