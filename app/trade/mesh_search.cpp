#include "app/trade/mesh_search.h"

#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "sim/study/front.h"

namespace app {
namespace {

// Shares of the time that is left when a phase begins.
constexpr double mesh_reference_share = 0.5, mesh_share = 0.4, combination_share = 0.25;
constexpr int most_combinations = 6;
constexpr double growth_of_work = 1.2;  // work goes as unknowns to this power, at the least

bool is_of_time(Axis axis) {
  return axis == Axis::time || axis == Axis::reference;
}

}  // namespace

// Leaves in `changes` those that are coarser.
const CaseRun* MeshSearch::find_finest(std::vector<MeshChange>& changes, double seconds) {
  const CaseRun& own = m_.notebook.run(time_, seconds);
  if (own.status != CaseStatus::done) return nullptr;
  while (!changes.empty()) {
    const MeshChange change = std::move(changes.back());
    changes.pop_back();
    if (!change.finest) continue;
    const TradeCase which = both(time_, change.change, Axis::mesh);
    const double least = own.work.median() * m_.comparison.seconds() * std::pow(change.growth, growth_of_work);
    if (least > seconds && !m_.notebook.recalls_only()) {
      m_.notebook.skip(which, "would take " + formatted("%.3g s", least) + " or more");
      continue;
    }
    const CaseRun& run = m_.notebook.run(which, seconds);
    if (run.status == CaseStatus::done) return &run;
  }
  return nullptr;
}

bool MeshSearch::measure() {
  const Spending spending(m_, "other meshes");
  std::vector<MeshChange> changes = mesh_changes(m_.scene());
  const CaseRun* const finest = find_finest(changes, mesh_reference_share * m_.notebook.left());
  if (!finest) {
    m_.note("no finer mesh could be afforded or made: the mesh error is not known, targets bound the time error only");
    return false;
  }
  for (const MeshChange& change : changes)
    m_.notebook.run(both(time_, change.change, Axis::mesh), mesh_share * m_.notebook.left());
  judge(*finest);
  return true;
}

// The total error is uncertain by the time error of the runs on the finest mesh and by what that mesh lacks itself: a
// third of the error of the next best, as halving the cells takes 3/4 of an error of second order away.
void MeshSearch::judge(const CaseRun& finest) {
  References references = m_.scorer.references();
  references.mesh_time = time_;
  const Apart time = m_.scorer.apart(m_.notebook.run(time_, 0), *references.time);
  references.mesh = &finest;
  m_.scorer.set(references);
  Apart next{1e300, 1e300, 1e300};
  for (const Score* score : m_.scores())
    if (score->mesh && score->mesh->rms < next.rms) next = *score->mesh;
  references.total_uncertainty = {time.rms + next.rms / 3, time.max + next.max / 3, time.pixels + next.pixels / 3};
  m_.scorer.set(references);
}

// Schemes and steps of the time axis on the other meshes: those of which it can be expected that they are worth it.
void MeshSearch::combine() {
  const Spending spending(m_, "other meshes");
  struct Guess {
    TradeCase which;
    sim::WorkError expected;
  };
  std::vector<const Score*> times, meshes;
  const Score& own = m_.scorer.score(m_.notebook.run(time_, 0));
  for (const Score* score : m_.scores()) {
    if (score->time && is_of_time(score->run->which.axis)) times.push_back(score);
    if (score->mesh && score->run->which.axis == Axis::mesh) meshes.push_back(score);
  }
  const double uncertain = error_of(m_.scorer.references().uncertainty, m_.goal);
  std::vector<Guess> guesses;
  for (const Score* mesh : meshes)
    for (const Score* time : times) {
      TradeCase which = mesh->run->which;
      for (const auto& [key, value] : time->run->which.settings) which = with(which, "", key, value);
      which.axis = Axis::rest;
      const std::string& label = mesh->run->which.label;
      which.label = time->run->which.label + label.substr(std::min(label.size(), own.run->which.label.size()));
      guesses.push_back({which,
                         {time->seconds * mesh->seconds / own.seconds,
                          error_of(*time->time, m_.goal) + error_of(*mesh->mesh, m_.goal) + uncertain}});
    }
  std::vector<sim::WorkError> expected;
  for (const Guess& guess : guesses) expected.push_back(guess.expected);
  std::vector<int> members = sim::front(expected);
  const auto distance = [&](int k) {
    if (m_.goal.kind == Goal::Kind::knee) return 0.0;
    return std::abs(
        std::log((m_.goal.kind == Goal::Kind::time ? expected[k].work : 2 * expected[k].error) / m_.goal.value));
  };
  std::ranges::stable_sort(members, {}, distance);
  for (std::size_t k = 0; k < members.size() && k < most_combinations; ++k)
    m_.notebook.run(guesses[members[k]].which, combination_share * m_.notebook.left());
}

}  // namespace app
