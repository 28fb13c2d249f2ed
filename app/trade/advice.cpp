#include "app/trade/advice.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "app/base/text.h"
#include "app/scene/value_text.h"
#include "sim/study/front.h"

namespace app {
namespace {

constexpr double time_margin = 1.1;  // wall times vary

// Candidates: runs that a user may take, with errors that are known.
std::vector<const Score*> candidates(const std::vector<const Score*>& scores) {
  std::vector<const Score*> list;
  for (const Score* score : scores)
    if (score->run->status == CaseStatus::done && std::isfinite(score->bound.rms) && score->seconds > 0)
      list.push_back(score);
  return list;
}

// A number, a list or a quoted string stays; a bare word is quoted.
std::string toml_value(const std::string& value) {
  double number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  const bool literal =
      (error == std::errc{} && end == value.data() + value.size()) || value.starts_with('"') || value.starts_with('[');
  return literal ? value : quoted_text(value);
}

const Score* knee_of(std::vector<const Score*> list) {
  const auto own = std::ranges::find_if(list, [](const Score* s) { return s->run->which.settings.empty(); });
  if (own != list.end()) {
    const double limit = (*own)->bound.rms;
    std::erase_if(list, [&](const Score* s) { return s->bound.rms > limit; });
  }
  std::vector<sim::WorkError> points;
  for (const Score* score : list) points.push_back({score->seconds, score->bound.rms});
  return list[sim::knee(points, sim::front(points))];
}

}  // namespace

std::vector<const Score*> front_of(const std::vector<const Score*>& scores) {
  const std::vector<const Score*> list = candidates(scores);
  std::vector<sim::WorkError> points;
  for (const Score* score : list) points.push_back({score->seconds, score->bound.rms});
  std::vector<const Score*> members;
  for (const int k : sim::front(points)) members.push_back(list[k]);
  return members;
}

bool meets(const Score& score, const Goal& goal) {
  if (goal.kind == Goal::Kind::knee) return true;
  if (goal.kind == Goal::Kind::time) return time_margin * score.seconds <= goal.value;
  return error_of(score.bound, goal) <= goal.value;
}

const Score* choose(const std::vector<const Score*>& scores, const Goal& goal) {
  const std::vector<const Score*> list = candidates(scores);
  if (list.empty()) return nullptr;
  if (goal.kind == Goal::Kind::knee) return knee_of(list);
  const bool by_time = goal.kind == Goal::Kind::time;
  const auto wanted = [&](const Score* s) { return by_time ? s->bound.rms : s->seconds; };
  const auto limited = [&](const Score* s) { return by_time ? s->seconds : error_of(s->bound, goal); };
  const auto better = [&](const Score* a, const Score* b) {
    const bool a_meets = meets(*a, goal), b_meets = meets(*b, goal);
    if (a_meets != b_meets) return a_meets;
    return a_meets ? wanted(a) < wanted(b) : limited(a) < limited(b);
  };
  const Score* const best = *std::ranges::min_element(list, better);
  // Those that are equal within 1 % are told apart by the other number.
  const bool met = meets(*best, goal);
  const auto first = [&](const Score* s) { return met ? wanted(s) : limited(s); };
  const auto second = [&](const Score* s) { return met ? limited(s) : wanted(s); };
  const Score* chosen = best;
  for (const Score* s : list)
    if (meets(*s, goal) == met && first(s) <= 1.01 * first(best) && second(s) < second(chosen)) chosen = s;
  return chosen;
}

std::string advice_toml(const TradeCase& which, const std::string& comment) {
  std::map<std::string, std::string> tables;  // "time", "body.0.mesh"
  for (const auto& [key, value] : which.settings) {
    if (key == thread_option) continue;  // of the command line
    const std::size_t dot = key.rfind('.');
    tables[key.substr(0, dot)] += key.substr(dot + 1) + " = " + toml_value(value) + "\n";
  }
  std::string text = "# " + comment + "\n";
  for (const auto& [table, lines] : tables) text += "\n[" + table + "]\n" + lines;
  return text;
}

}  // namespace app
