#include <algorithm>
#include <stdexcept>

#include "app/base/text.h"
#include "app/trade/side_by_side.h"

namespace app {
namespace {

Shown shown_of(const std::string& name, const Score& score) {
  return {name, bounded_text(score) + formatted(", %.2g s", score.seconds), score.run};
}

const Score& named(const std::vector<const Score*>& scores, const std::string& name) {
  std::vector<const Score*> found;
  for (const Score* score : scores) {
    if (score->run->path.frames() == 0) continue;
    if (score->run->which.label == name) return *score;
    if (score->run->which.label.find(name) != std::string::npos) found.push_back(score);
  }
  if (found.size() == 1) return *found.front();
  std::string which = found.empty() ? "no run that was measured is called so" : "it is a part of the names of several";
  for (std::size_t k = 0; k < std::min<std::size_t>(found.size(), 5); ++k)
    which += (k == 0 ? ": " : "; ") + found[k]->run->which.label;
  throw std::runtime_error("--show " + name + ": " + which + " (the table lists their names)");
}

}  // namespace

std::vector<Shown> choose_shown(Measurement& m, const Advice& advice, const std::vector<std::string>& names) {
  const std::vector<const Score*> scores = m.scores();
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
  for (const std::string& name : names) {
    const Score& score = named(scores, name);
    add(score.run->which.label, score);
  }
  return all;
}

}  // namespace app
