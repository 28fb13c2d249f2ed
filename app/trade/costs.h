// What runs cost by themselves, on a machine that also does other things.
#pragma once

#include <deque>
#include <map>
#include <string>

#include "app/trade/case.h"

namespace app {

// Runs of one kind have the same bodies, linear solver and threads: a force evaluation, a factorisation, a linear
// iteration takes as long in each. Where a solver chooses by itself, those that iterate are not those that factorise:
// there an iteration is something else.
std::string kind_of(const CaseRun& run);

// Steps that were timed anew, by kind.
using TimedKinds = std::map<std::string, std::vector<sim::TimedStep>>;

// Counts times unit costs, which all runs of one kind share: of two such runs the one that does less is the faster,
// whatever else the machine did while they were timed.
class Costs {
 public:
  Costs() = default;
  // From the timed steps of all runs; of a kind that was timed anew at the pace of those steps.
  Costs(const std::deque<CaseRun>& runs, const TimedKinds& anew);

  // Wall seconds per simulated second; the least that the run took where no step was timed.
  double seconds(const CaseRun& run) const;

 private:
  std::map<std::string, sim::UnitCosts> kinds_;
};

}  // namespace app
