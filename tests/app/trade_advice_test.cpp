// What a trade is asked for, how deep it goes, which run it advises: on numbers that are known.
#include <gtest/gtest.h>

#include "app/trade/advice.h"
#include "app/trade/plan.h"
#include "app/trade/reference_search.h"
#include "app/trade/step_search.h"
#include "tests/app/temporary_folder.h"

namespace app {
namespace {

TEST(Goal, IsReadFromTargetOrBudget) {
  const sim::Time time{.seconds = 4.0, .fps = 25, .integrator = "sdirk2"};
  const auto value = [&](const char* target, const char* budget) {
    TradeOptions options;
    options.target = target;
    options.budget = budget;
    return read_goal(options, time).value;
  };
  EXPECT_DOUBLE_EQ(value("1%", ""), 0.01);
  EXPECT_DOUBLE_EQ(value("0.002", ""), 0.002);
  EXPECT_DOUBLE_EQ(value("1.5px", ""), 1.5);
  EXPECT_DOUBLE_EQ(value("", "40ms"), 1.0);
  EXPECT_DOUBLE_EQ(value("", "60s"), 15);
  EXPECT_DOUBLE_EQ(value("", "2min"), 30);
  EXPECT_DOUBLE_EQ(value("", "realtime"), 1);
  for (const char* wrong : {"0%", "-1%", "1 per cent", "px", "1e999%", "nan%", "%"})
    EXPECT_NE(error_of([&] { value(wrong, ""); }).find(std::string("--target ") + wrong + ": must be"),
              std::string::npos)
        << wrong;
  for (const char* wrong : {"33", "fast", "-1s", "0ms", "1h"})
    EXPECT_NE(error_of([&] { value("", wrong); }).find(std::string("--budget ") + wrong + ": must be"),
              std::string::npos)
        << wrong;
  EXPECT_NE(error_of([&] { value("1%", "realtime"); }).find("give one of them"), std::string::npos);
}

TEST(Plan, IsAsDeepAsTheTimeAllows) {
  EXPECT_EQ(affordable_plan(1e6, 1, 90).depth, 8);
  EXPECT_EQ(affordable_plan(1e6, 1, 90).frames, 90);
  const Plan less = affordable_plan(100, 10, 90);
  EXPECT_EQ(less.depth, 1);
  EXPECT_LT(less.frames, 90);
  EXPECT_EQ(affordable_plan(1e-3, 1e3, 90).frames, 12);
}

// Runs with known times and bounds.
struct Scores {
  std::vector<CaseRun> runs;
  std::vector<Score> list;
  Scores(std::initializer_list<std::pair<double, double>> points) {
    for (const auto& [seconds, error] : points) {
      CaseRun run;
      run.status = CaseStatus::done;
      run.which.settings = {{"time.substeps", std::to_string(runs.size())}};
      run.work.seconds = {seconds};
      runs.push_back(run);
      Score score;
      score.seconds = seconds;
      score.bound = {error, error, 100 * error};
      list.push_back(score);
    }
    for (std::size_t k = 0; k < runs.size(); ++k) list[k].run = &runs[k];
  }
  std::vector<const Score*> pointers() const {
    std::vector<const Score*> all;
    for (const Score& score : list) all.push_back(&score);
    return all;
  }
};

TEST(Advice, IsTheFastestWithinTheErrorAndTheMostAccurateWithinTheTime) {
  const Scores scores{{1, 0.1}, {2, 0.009}, {3, 0.011}, {4, 0.001}, {8, 0.0009}};
  const auto chosen = [&](const Goal& goal) { return choose(scores.pointers(), goal)->seconds; };
  EXPECT_EQ(chosen({Goal::Kind::error, 0.01, ""}), 2);
  EXPECT_EQ(chosen({Goal::Kind::pixels, 0.2, ""}), 4);
  EXPECT_EQ(chosen({Goal::Kind::time, 5, ""}), 4);
  EXPECT_EQ(chosen({Goal::Kind::time, 2.1, ""}), 1);    // a tenth is kept in hand
  EXPECT_EQ(chosen({Goal::Kind::error, 1e-6, ""}), 8);  // none is within it: the nearest
  EXPECT_EQ(chosen({Goal::Kind::time, 0.01, ""}), 1);
  EXPECT_EQ(chosen({}), 4);
}

// Errors that agree to a percent do not outweigh half the time, nor such times a tenth of the error.
TEST(Advice, TakesTheBetterOfTwoThatAreEqual) {
  const Scores scores{{4, 0.00100}, {2, 0.001001}, {1.0, 0.01}, {1.005, 0.001}};
  const auto chosen = [&](const Goal& goal) { return choose(scores.pointers(), goal)->seconds; };
  EXPECT_EQ(chosen({Goal::Kind::time, 5}), 1.005);
  EXPECT_EQ(chosen({Goal::Kind::error, 0.02}), 1.005);
  EXPECT_EQ(chosen({Goal::Kind::error, 0.0001}), 1.005) << "nothing meets it: nearest, then fastest";
}

// e = C h^order: the steps that bring an error to what is wanted.
TEST(Steps, FollowFromAnErrorAndItsOrder) {
  EXPECT_EQ(substeps_for(0.08, 1, 1, 0.01), 8);
  EXPECT_EQ(substeps_for(0.04, 1, 2, 0.01), 2);
  EXPECT_EQ(substeps_for(0.04, 3, 2, 0.01), 6);
  EXPECT_EQ(substeps_for(0.001, 3, 2, 0.01), 1) << "a third of the steps is enough";
  EXPECT_EQ(fine_enough(8, 0.04, 0.01), 16);
  EXPECT_EQ(fine_enough(8, 0.2, 0.01), 64);
  EXPECT_EQ(fine_enough(4, 0.001, 0.01), 8) << "at least the next";
}

// Of two runs of one kind the one that does less is the faster, whatever the clock said; a run that was held up costs
// what its counts cost in others.
TEST(Costs, AreCountsTimesUnitsThatAKindShares) {
  std::deque<CaseRun> runs(3);
  const double least[] = {2.5, 2.0, 9.0};
  const sim::StepCounts counts[] = {{60, 401, 100, 100}, {60, 729, 183, 183}, {120, 1000, 250, 250}};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    Work& work = runs[k].work;
    work.newton = 1;
    work.seconds = {least[k]};
    work.steps = counts[k].steps;
    work.force_evaluations = counts[k].force_evaluations;
    work.factorisations = counts[k].factorisations;
    work.linear = counts[k].linear;
    for (int step = 0; step < 12; ++step) {
      const double f = 4 + step % 3, factors = 1 + step % 4, held_up = k == 2 && step % 2 == 0 ? 3 : 1;
      runs[k].timed.push_back({{1, f, factors, factors}, held_up * (1e-3 + 1e-3 * f + 4e-3 * factors)});
    }
  }
  const Costs costs(runs, {});
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const sim::StepCounts& c = counts[k];
    const double expected = 1e-3 * c.steps + 1e-3 * c.force_evaluations + 4e-3 * c.linear;
    EXPECT_NEAR(costs.seconds(runs[k]), expected, 1e-6 * expected) << k;
  }
  EXPECT_LT(costs.seconds(runs[0]), costs.seconds(runs[1]));
  runs[0].which.settings = {{"body.0.mesh.refine", "1"}};
  runs[0].timed.clear();
  EXPECT_EQ(Costs(runs, {}).seconds(runs[0]), 2.5) << "nothing is known of its kind but its own time";
}

TEST(Advice, IsWrittenAsTables) {
  const TradeCase which{"",
                        Axis::rest,
                        {{"time.integrator", "tr-bdf2"},
                         {"body.0.mesh.cells", "[2, 1]"},
                         {"time.substeps", "4"},
                         {"body.0.mesh.element", "\"tri6\""}}};
  EXPECT_EQ(advice_toml(which, "why"),
            "# why\n\n[body.0.mesh]\ncells = [2, 1]\nelement = \"tri6\"\n\n[time]\nintegrator = \"tr-bdf2\"\n"
            "substeps = 4\n");
}

}  // namespace
}  // namespace app
