#include "app/trade/measurement.h"

#include <algorithm>

namespace app {

void Measurement::note(const std::string& text) {
  notes.push_back(text);
  notebook.say("note: " + text);
}

std::vector<const Score*> Measurement::scores() {
  scorer.set(Costs(notebook.runs(), timed_anew));
  std::vector<const Score*> all;
  for (const CaseRun& run : notebook.runs()) all.push_back(&scorer.score(run));
  return all;
}

Spending::~Spending() {
  auto& spent = measurement_.spent;
  const auto found = std::ranges::find(spent, phase_, &std::pair<std::string, double>::first);
  if (found == spent.end())
    spent.emplace_back(phase_, watch_.seconds());
  else
    found->second += watch_.seconds();
}

}  // namespace app
