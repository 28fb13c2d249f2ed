// What the parts of a step cost, found from timed steps of which some were held up.
#include "sim/study/unit_costs.h"

#include <gtest/gtest.h>

#include <vector>

namespace sim {
namespace {

// Steps that cost 2 ms each, 5 ms a force evaluation, 11 ms a factorisation, 3 ms an iteration.
std::vector<TimedStep> steps(int count, int every, double held_up) {
  std::vector<TimedStep> all;
  for (int k = 0; k < count; ++k) {
    const StepCounts c{1, 1.0 + k % 3, double(k % 2), 4.0 + k % 5};
    const double by_itself = 2e-3 + 5e-3 * c.force_evaluations + 11e-3 * c.factorisations + 3e-3 * c.linear;
    all.push_back({c, by_itself * (every > 0 && k % every == 0 ? held_up : 1)});
  }
  return all;
}

TEST(UnitCosts, AreFoundFromStepsWhateverHeldSomeOfThemUp) {
  for (const auto& [every, held_up] : {std::pair(0, 1.0), std::pair(3, 4.0), std::pair(7, 2.0)}) {
    const UnitCosts costs = unit_costs(steps(60, every, held_up));
    EXPECT_NEAR(costs.step, 2e-3, 1e-9) << every;
    EXPECT_NEAR(costs.force_evaluation, 5e-3, 1e-9) << every;
    EXPECT_NEAR(costs.factorisation, 11e-3, 1e-9) << every;
    EXPECT_NEAR(costs.linear, 3e-3, 1e-9) << every;
    EXPECT_NEAR(costs.of({60, 100, 30, 200}), 0.12 + 0.5 + 0.33 + 0.6, 1e-6) << every;
  }
}

// Where two counts go together only their sum is known; no cost is negative, and the step costs what it takes.
TEST(UnitCosts, AreNeverNegative) {
  std::vector<TimedStep> all;
  for (int k = 0; k < 20; ++k) {
    const double n = 2 + k % 4;
    all.push_back({{1, n, n, n}, 1e-3 * n * (1 + 0.02 * (k % 3))});
  }
  const UnitCosts costs = unit_costs(all);
  for (const double cost : {costs.step, costs.force_evaluation, costs.factorisation, costs.linear}) EXPECT_GE(cost, 0);
  EXPECT_NEAR(costs.of({1, 3, 3, 3}), 3e-3, 0.1e-3);
  EXPECT_EQ(unit_costs({}).of({1, 1, 1, 1}), 0);
}

}  // namespace
}  // namespace sim
