#include <algorithm>
#include <stdexcept>

#include "app/base/text.h"
#include "app/trade/side_by_side.h"

namespace app {
namespace {

Shown shown_of(const std::string& name, const Score& score) {
  return {name, bounded_text(score) + formatted(", %.2g s", score.seconds), score.run};
}

}  // namespace

std::vector<Shown> choose_shown(Measurement& m, const Advice& advice) {
  const References& references = m.scorer.references();
  const CaseRun* const reference = references.mesh ? references.mesh : references.time;
  if (!reference) throw std::runtime_error("--show: there is no reference to show runs beside");
  std::vector<Shown> all = {
      {"reference: " + reference->which.label, formatted("%.2g s", m.scorer.score(*reference).seconds), reference}};
  const auto add = [&](const std::string& name, const Score& score) {
    const bool there = std::ranges::find(all, score.run, &Shown::run) != all.end();
    if (!there && score.run->path.frames() > 0) all.push_back(shown_of(name, score));
  };
  if (advice.own) add("the scene as it is", *advice.own);
  if (advice.chosen) add("advice: " + advice.chosen->run->which.label, *advice.chosen);
  for (const TradeCase& which : m.named) {
    const CaseRun& run = m.notebook.run(which, 0);
    if (run.path.frames() == 0) m.note(which.label + " is not drawn: " + run.reason);
    add(which.label, m.scorer.score(run));
  }
  return all;
}

}  // namespace app
