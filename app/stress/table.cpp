#include "app/stress/table.h"

#include <map>

#include "app/base/number_text.h"
#include "app/base/text.h"

namespace app {
namespace {

// A gain of energy of this share, and less, is the tolerance of the steps.
constexpr double counted_gain = 1e-3;

const char* text(sim::Verdict verdict) {
  switch (verdict) {
    case sim::Verdict::recovered:
      return "recovered";
    case sim::Verdict::at_rest_loaded:
      return "at rest, loaded";
    case sim::Verdict::other_equilibrium:
      return "other equilibrium";
    case sim::Verdict::moving:
      return "still moving";
    case sim::Verdict::iterating:
      return "still iterating";
    case sim::Verdict::stopped:
      return "stopped";
  }
  return "";
}

const char* verdict_of(const CaseResult& result) {
  return result.refused.empty() ? text(result.recovery.verdict) : "refused";
}

}  // namespace

std::string table_header() {
  return formatted("%-36s %-10s %-18s %-17s %-17s %9s %9s %5s %5s %5s %7s %6s %8s %7s %8s", "extreme", "body",
                   "material", "integrator", "verdict", "distance", "min J", "inv.", "wound", "steps", "unconv.",
                   "halved", "its/step", "seconds", "gain");
}

std::string table_row(const StabilityCase& c, const CaseResult& result) {
  const std::string row =
      formatted("%-36s %-10s %-18s %-17s %-17s", (c.extreme->group + "/" + c.extreme->name).c_str(),
                c.subject->body.c_str(), c.subject->material.c_str(), c.subject->scheme.c_str(), verdict_of(result));
  if (!result.refused.empty()) return row;
  const sim::Recovery& r = result.recovery;
  const std::string gain = r.gain ? formatted(" %8.1e", *r.gain) : "";
  return row +
         formatted(" %9.1e %9.2g %5d %5d %5lld %7d %6lld %8.2f %7.2f", r.distance, r.min_J, r.inverted, r.wound,
                   static_cast<long long>(r.steps), r.not_converged, static_cast<long long>(r.splits),
                   static_cast<double>(r.newton) / static_cast<double>(std::max<std::int64_t>(r.steps, 1)),
                   result.seconds) +
         gain + (result.locking.empty() ? "" : "  locking");
}

std::string table_summary(const std::vector<StabilityCase>& cases, const std::vector<CaseResult>& results) {
  std::map<std::string, int> verdicts, reasons;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    ++verdicts[verdict_of(results[k])];
    if (!results[k].refused.empty()) ++reasons["refused: " + results[k].refused];
    if (!results[k].recovery.failure.empty()) ++reasons["stopped: " + results[k].recovery.failure];
    if (!results[k].recovery.reason.empty()) ++reasons["not converged: " + results[k].recovery.reason];
    if (results[k].recovery.gain.value_or(0) > counted_gain) ++reasons["energy gained by " + cases[k].subject->scheme];
    if (!results[k].locking.empty()) ++reasons["remark: " + results[k].locking];
  }
  std::string text = std::to_string(cases.size()) + " cases:";
  for (const auto& [verdict, count] : verdicts) text += " " + std::to_string(count) + " " + verdict + ",";
  text.back() = '\n';
  for (const auto& [reason, count] : reasons) text += "  " + std::to_string(count) + " x " + reason + '\n';
  return text;
}

std::string stability_csv(const std::vector<StabilityCase>& cases, const std::vector<CaseResult>& results) {
  std::string csv =
      "extreme,seed,body,material,integrator,verdict,distance,min_J,inverted,wound,steps,not_converged,halved,newton,"
      "linear,seconds,gain,locking,reason\n";
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const StabilityCase& c = cases[k];
    const CaseResult& result = results[k];
    const sim::Recovery& r = result.recovery;
    csv += quoted_field(c.extreme->group + "/" + c.extreme->name) + "," + std::to_string(c.seed) + "," +
           quoted_field(c.subject->body) + "," + quoted_field(c.subject->material) + "," + c.subject->scheme + "," +
           quoted_field(verdict_of(result));
    for (const double number : {r.distance, r.min_J}) append_number(csv += ',', number);
    for (const std::int64_t number : {std::int64_t{r.inverted}, std::int64_t{r.wound}, r.steps,
                                      std::int64_t{r.not_converged}, r.splits, r.newton, r.linear})
      append_number(csv += ',', number);
    append_number(csv += ',', result.seconds);
    csv += ',';
    if (r.gain) append_number(csv, *r.gain);
    csv += "," + (result.locking.empty() ? "" : quoted_field(result.locking));
    csv += "," +
           quoted_field(!result.refused.empty() ? result.refused
                        : !r.failure.empty()    ? r.failure
                                                : r.reason) +
           '\n';
  }
  return csv;
}

}  // namespace app
