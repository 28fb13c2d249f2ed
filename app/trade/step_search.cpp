#include "app/trade/step_search.h"

#include <algorithm>
#include <cmath>

#include "app/trade/lists.h"

namespace app {
namespace {

constexpr double run_share = 0.4;      // of the time that is left: one run
constexpr int most_substeps = 64;      // steps a frame
constexpr double follows_order = 0.3;  // of the size: larger errors follow no order

}  // namespace

// e = C h^order
int substeps_for(double error, int substeps, int order, double aim) {
  const double times = std::pow(error / aim, 1.0 / order);
  return static_cast<int>(std::ceil(std::min(1e6, std::max(1.0, times * substeps * (1 - 1e-9)))));
}

bool StepSearch::run(Latest& latest, int substeps) {
  latest.substeps = substeps;
  latest.run = &m_.notebook.run(time_case(m_.scene(), latest.scheme, substeps), run_share * m_.notebook.left());
  return latest.run->status == CaseStatus::done;
}

double StepSearch::error(const Latest& latest) {
  const Score& score = m_.scorer.score(*latest.run);
  return score.time ? error_of(*score.time, m_.goal) : 0;
}

void StepSearch::first_runs() {
  const Spending spending(m_, "first runs");
  for (const std::string& scheme : implicit_schemes(m_.scene())) {
    Latest latest{scheme, 1, nullptr};
    bool done = run(latest, 1);
    for (int n = 2; !done && latest.run->status == CaseStatus::failed && n <= 4; n *= 2) done = run(latest, n);
    if (done) latest_.push_back(latest);
  }
}

void StepSearch::fill(double budget) {
  const Spending spending(m_, "steps");
  constexpr double in_hand = 0.85;
  for (Latest& latest : latest_) {
    const double room = in_hand * budget / latest.run->work.least() * latest.substeps;
    const int substeps = static_cast<int>(std::min<double>(most_substeps, room));
    const Latest before = latest;
    if (substeps > latest.substeps && !run(latest, substeps)) latest = before;
  }
}

int StepSearch::next_substeps(const Latest& latest, double aim) {
  const double found = error(latest), rms = m_.scorer.score(*latest.run).time->rms;
  if (rms > follows_order) return 2 * latest.substeps;
  return substeps_for(found, latest.substeps, latest.run->order, aim);
}

void StepSearch::reach(double aim) {
  const Spending spending(m_, "steps");
  constexpr int rounds = 2;
  constexpr double worth = 3;  // times what the fastest takes that is there: slower ones are not tried
  double fastest = 1e300;
  for (int round = 0; round < rounds; ++round) {
    std::vector<std::pair<double, Latest*>> wishes;  // s per simulated second, expected
    for (Latest& latest : latest_) {
      const double now = latest.run->work.least();
      if (error(latest) <= aim) {
        fastest = std::min(fastest, now);
        continue;
      }
      const int substeps = next_substeps(latest, aim);
      if (substeps <= most_substeps) wishes.emplace_back(now * substeps / latest.substeps, &latest);
    }
    std::ranges::sort(wishes, {}, &std::pair<double, Latest*>::first);
    for (const auto& [seconds, latest] : wishes) {
      if (seconds > worth * fastest) continue;
      const Latest before = *latest;
      if (!run(*latest, next_substeps(before, aim)))
        *latest = before;
      else if (error(*latest) <= aim)
        fastest = std::min(fastest, latest->run->work.least());
    }
  }
}

int StepSearch::substeps(const std::string& scheme, double aim) {
  const auto found = std::ranges::find(latest_, scheme, &Latest::scheme);
  return found == latest_.end() ? 1 : std::min(most_substeps, next_substeps(*found, aim));
}

}  // namespace app
