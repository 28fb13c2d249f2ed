#include "app/trade/costs.h"

namespace app {
namespace {

// Settings that change how often something is done, not how long it takes.
bool changes_counts_only(const std::string& key) {
  return key.starts_with("time.") || key.starts_with("contact.") || key == "solver.tolerance" ||
         key == "solver.lag_iterations";
}

}  // namespace

std::string kind_of(const CaseRun& run) {
  std::map<std::string, std::string> sorted;
  for (const auto& [key, value] : run.which.settings)
    if (!changes_counts_only(key)) sorted[key] = value;
  constexpr double iterations = 4;  // for each system: a direct solve counts one
  std::string kind = !(run.work.newton > 0)                           ? "explicit"
                     : run.work.linear > iterations * run.work.newton ? "iterative"
                                                                      : "direct";
  for (const auto& [key, value] : sorted) kind += ";" + key + "=" + value;
  return kind;
}

Costs::Costs(const std::deque<CaseRun>& runs, const TimedKinds& anew) {
  TimedKinds all;
  for (const CaseRun& run : runs) {
    std::vector<sim::TimedStep>& steps = all[kind_of(run)];
    steps.insert(steps.end(), run.timed.begin(), run.timed.end());
  }
  for (const auto& [kind, steps] : all) {
    if (steps.empty()) continue;
    const sim::UnitCosts costs = sim::unit_costs(steps);
    const auto again = anew.find(kind);
    kinds_[kind] = again == anew.end() ? costs : costs * sim::pace(again->second, costs);
  }
}

double Costs::seconds(const CaseRun& run) const {
  const auto found = kinds_.find(kind_of(run));
  return found == kinds_.end() ? run.work.least() : found->second.of(run.work.counts());
}

}  // namespace app
