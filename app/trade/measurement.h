// What the phases of a search share: the scene, the runs that were made, what they show, what the user should know.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/trade/goal.h"
#include "app/trade/notebook.h"
#include "app/trade/score.h"

namespace app {

class Measurement {
 public:
  // `comparison`: its stretch is settled by the plan.
  // `named`: cases that are run in any case.
  Measurement(Comparison& comparison, Notebook& notebook, Scorer& scorer, Goal goal, std::vector<TradeCase> named)
      : comparison(comparison), notebook(notebook), scorer(scorer), goal(std::move(goal)), named(std::move(named)) {}

  void note(const std::string& text);
  // Every run that has been scored, at what it costs by the counts and times that are known now.
  std::vector<const Score*> scores();
  const Document& scene() const { return comparison.scene.document; }
  bool keeps_mesh() const { return comparison.options.trade.keep_mesh; }

  Comparison& comparison;
  Notebook& notebook;
  Scorer& scorer;
  const Goal goal;
  const std::vector<TradeCase> named;
  std::vector<std::string> notes;
  std::vector<std::pair<std::string, double>> spent;  // s, by phase
  TimedKinds timed_anew;
};

// Adds the time of its life to what was spent.
class Spending {
 public:
  Spending(Measurement& measurement, std::string phase) : measurement_(measurement), phase_(std::move(phase)) {}
  ~Spending();
  Spending(const Spending&) = delete;
  Spending& operator=(const Spending&) = delete;

 private:
  Measurement& measurement_;
  std::string phase_;
  Stopwatch watch_;
};

}  // namespace app
