#include "app/trade/reference_search.h"

#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "app/trade/lists.h"

namespace app {
namespace {

constexpr double reference_share = 0.6;                         // of the time that is left
constexpr int coarsest = 4, finest = 256, fine_for_chaos = 32;  // steps a frame

// The four runs; fewer where one could not be made, which is the last then.
std::vector<const CaseRun*> reference_runs(Measurement& m, int fine) {
  std::vector<const CaseRun*> runs;
  for (const TradeCase& which : reference_cases(m.scene(), fine)) {
    runs.push_back(&m.notebook.run(which, runs.empty() ? reference_share * m.notebook.left() : m.notebook.left()));
    if (runs.back()->status != CaseStatus::done) break;
  }
  return runs;
}

bool all_done(const std::vector<const CaseRun*>& runs) {
  return runs.back()->status == CaseStatus::done;
}

Apart larger(const Apart& a, const Apart& b) {
  return {std::max(a.rms, b.rms), std::max(a.max, b.max), std::max(a.pixels, b.pixels)};
}

void take(Measurement& m, const std::vector<const CaseRun*>& runs) {
  References references;
  references.time = runs[0];
  references.check =
      sim::check_reference({runs[0]->path, runs[1]->path, runs[2]->path, runs[3]->path}, m.comparison.points);
  m.scorer.set(references);
  references.uncertainty = larger(m.scorer.apart(*runs[0], *runs[1]), m.scorer.apart(*runs[0], *runs[2]));
  m.scorer.set(references);
}

// `fine_as_can_be`: more steps would not carry positions further.
void tell(Measurement& m, bool fine_as_can_be) {
  const sim::ReferenceCheck& check = m.scorer.references().check;
  const std::string from =
      "halving the step of the reference moves it by 0.5 % of the size at t = " + formatted("%.3g s", check.horizon);
  if (check.diverges && fine_as_can_be)
    m.note("the motion is chaotic: " + from +
           "; positions mean something up to there, and errors are those up to there. "
           "Beyond, compare the centre of mass and the energy (columns centre_error, mean_energy)");
  else if (check.diverges)
    m.note(from + ", and a finer one does not fit into the time: errors are those up to there");
  if (!check.agrees)
    m.note("the reference cannot be trusted: tr-bdf2 and sdirk2 are " + percent(check.apart) +
           " apart, and halving its step brings sdirk2 no nearer (halving that of tr-bdf2 moves it by " +
           percent(check.moved) + ")");
}

bool say_there_is_none(Measurement& m, const CaseRun& failed) {
  m.note("there is no reference, so no error is known: " + failed.which.label + ": " + failed.reason);
  return false;
}

// s, of four runs as finely stepped as that, by what these took.
double predicted_seconds(const Measurement& m, const std::vector<const CaseRun*>& runs, double finer) {
  double sum = 0;
  for (const CaseRun* run : runs) sum += run->work.least() * m.comparison.seconds();
  return finer * sum;
}

}  // namespace

int find_reference(Measurement& m, int fine) {
  const Spending spending(m, "reference");
  for (;; fine /= 2) {
    const std::vector<const CaseRun*> runs = reference_runs(m, fine);
    if (all_done(runs)) {
      take(m, runs);
      tell(m, true);
      return fine;
    }
    if (fine <= coarsest || runs.back()->status == CaseStatus::failed || m.notebook.recalls_only()) {
      say_there_is_none(m, *runs.back());
      return 0;
    }
  }
}

int fine_enough(int fine, double uncertainty, double wanted) {
  const double factor = std::sqrt(uncertainty / wanted);
  int times = 2;
  while (times < factor && times < 16) times *= 2;
  return fine * times;
}

void prepare_reference(Measurement& m) {
  const Spending spending(m, "reference");
  reference_runs(m, coarsest);
}

bool refine_reference(Measurement& m, const std::function<double()>& wanted) {
  const Spending spending(m, "reference");
  const References& references = m.scorer.references();
  double horizon = 0;
  bool fine_as_can_be = true;
  for (int fine = coarsest;;) {
    const std::vector<const CaseRun*> runs = reference_runs(m, fine);
    const bool more = fine < finest;
    if (!all_done(runs)) {
      if (runs.back()->status == CaseStatus::failed && more && !references.time) {
        fine *= 2;
        continue;
      }
      if (!references.time) return say_there_is_none(m, *runs.back());
      fine_as_can_be = false;
      break;
    }
    take(m, runs);
    const sim::ReferenceCheck& check = references.check;
    const double uncertainty = error_of(references.uncertainty, m.goal), limit = wanted();
    if (!check.diverges && uncertainty <= limit) break;
    // Chaos ends the time in which positions mean something wherever it does; a coarse step ends it where it is coarse.
    if (check.diverges && ((horizon > 0 && check.horizon < 1.05 * horizon) || fine >= fine_for_chaos)) break;
    horizon = check.horizon;
    int next = check.diverges ? 2 * fine : fine_enough(fine, uncertainty, limit);
    while (next > 2 * fine && predicted_seconds(m, runs, double(next) / fine) > reference_share * m.notebook.left())
      next /= 2;
    if (!more || predicted_seconds(m, runs, double(next) / fine) > reference_share * m.notebook.left()) {
      if (!check.diverges)
        m.note("the reference is uncertain by " + percent(check.uncertainty) +
               ": a finer one does not fit into the time");
      fine_as_can_be = false;
      break;
    }
    fine = next;
  }
  tell(m, fine_as_can_be);
  return true;
}

}  // namespace app
