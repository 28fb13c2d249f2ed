#include "app/trade/table.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "app/base/number_text.h"
#include "app/base/text.h"
#include "app/trade/advice.h"
#include "sim/study/slope.h"

namespace app {
namespace {

constexpr double meaningful = 0.3;  // of the size: larger errors follow no order

std::string in_percent(const std::optional<Apart>& apart) {
  return apart ? formatted("%.2g", 100 * apart->rms) : "";
}

std::string time_error(const Score& score, const References& references) {
  if (!score.time || !score.below) return in_percent(score.time ? score.time : score.model);
  return formatted("<%.2g", 100 * (score.time->rms + references.check.uncertainty));
}

std::string row(const Score& score, bool on_front, const References& references) {
  const CaseRun& run = *score.run;
  const std::optional<Apart>& whole = score.total ? score.total : score.time ? score.time : score.model;
  return formatted("%c %-60s %9s %9s %9s %8.3g %9.3g %9.3g %8.0f %7.0f %8.0f%s\n", on_front ? '*' : ' ',
                   run.which.label.c_str(), time_error(score, references).c_str(), in_percent(score.mesh).c_str(),
                   in_percent(score.total).c_str(), whole ? whole->pixels : 0.0, score.seconds, run.work.least(),
                   run.work.force_evaluations, run.work.factorisations, run.work.linear,
                   ((run.not_converged > 0 ? "  not converged" : "") +
                    (run.training > 0 ? formatted("  after %.2g s of training", run.training) : std::string()))
                       .c_str());
}

// Errors of one integrator.
struct ErrorsByStep {
  int order = 0;
  std::vector<double> steps, errors;
};

// Over the two smallest steps: at larger ones the motion is not resolved yet.
double finest_slope(const ErrorsByStep& series) {
  std::vector<std::size_t> order(series.steps.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t k) { return series.steps[k]; });
  const double steps[] = {series.steps[order[0]], series.steps[order[1]]},
               errors[] = {series.errors[order[0]], series.errors[order[1]]};
  return sim::log_slope(steps, errors);
}

// The cells of one row; what is not known stays empty.
class Row {
 public:
  Row& text(const std::string& value) {
    cells_.push_back(quoted_field(value));
    return *this;
  }
  Row& number(double value) {
    std::string cell;
    if (std::isfinite(value)) append_number(cell, value);
    cells_.push_back(cell);
    return *this;
  }
  Row& apart(const std::optional<Apart>& value) {
    if (value) return number(value->rms).number(value->max).number(value->pixels);
    cells_.insert(cells_.end(), 3, "");
    return *this;
  }
  std::string line() const {
    std::string line;
    for (const std::string& cell : cells_) line += (&cell == &cells_.front() ? "" : ",") + cell;
    return line + '\n';
  }

 private:
  std::vector<std::string> cells_;
};

// Failures one by one; what was skipped in one paragraph.
std::string left_out(const std::vector<const Score*>& scores) {
  std::string failed, skipped;
  for (const Score* score : scores) {
    const CaseRun& run = *score->run;
    if (run.status == CaseStatus::failed) failed += "  failed: " + run.which.label + ": " + run.reason + '\n';
    if (run.status == CaseStatus::skipped)
      skipped += (skipped.empty() ? "" : "; ") + run.which.label + " (" + run.reason + ")";
  }
  return failed + (skipped.empty() ? "" : "  skipped: " + skipped + '\n');
}

constexpr std::string_view header =
    "case,axis,settings,status,reason,step,dofs,time_error,time_error_max,time_pixels,mesh_error,mesh_error_max,"
    "mesh_pixels,model_error,model_error_max,model_pixels,total_error,total_error_max,total_pixels,error_bound,"
    "resolved,"
    "energy_drift,momentum_drift,centre_error,mean_energy,seconds_per_second,least_wall_per_second,cpu_per_second,"
    "training_seconds,timed_runs,"
    "steps_per_second,newton_per_second,force_evaluations_per_second,factorisations_per_second,linear_per_second,"
    "not_converged,compared_seconds,front,id\n";

}  // namespace

std::string table_text(const std::vector<const Score*>& scores, const References& references) {
  const std::vector<const Score*> members = front_of(scores);
  std::vector<const Score*> done, other;
  for (const Score* score : scores) (score->run->status == CaseStatus::done ? done : other).push_back(score);
  std::ranges::stable_sort(done, {}, [](const Score* s) { return s->seconds; });
  constexpr const char* head = "  %-60s %9s %9s %9s %8s %9s %9s %8s %7s %8s\n";
  std::string text = formatted(head, "", "time", "mesh", "total", "", "by", "wall", "force", "factor-", "linear") +
                     formatted(head, "per simulated second; * = on the front", "error %", "error %", "error %",
                               "pixels", "counts s", "s", "evals", "isations", "its");
  for (const Score* score : done) text += row(*score, std::ranges::find(members, score) != members.end(), references);
  text += left_out(other);
  for (const Slope& slope : slopes(scores))
    text += formatted("  %s: order %d, measured %.2f\n", slope.integrator.c_str(), slope.order, slope.slope);
  return text;
}

std::string trade_csv(const std::vector<const Score*>& scores, const Comparison& comparison) {
  constexpr const char* names[] = {"done", "failed", "skipped"};
  const std::vector<const Score*> members = front_of(scores);
  std::string text(header);
  for (const Score* score : scores) {
    const CaseRun& run = *score->run;
    const Work& work = run.work;
    Row row;
    row.text(run.which.label).text(std::string(axis_name(run.which.axis))).text(settings_text(run.which));
    row.text(names[static_cast<int>(run.status)]).text(run.reason).number(run.step).number(double(run.dofs));
    row.apart(score->time).apart(score->mesh).apart(score->model).apart(score->total);
    row.number(score->bound.rms).number(score->resolved ? 1 : 0);
    row.number(score->energy_drift).number(score->momentum_drift).number(score->centre).number(score->mean_energy);
    row.number(score->seconds)
        .number(work.least())
        .number(work.cpu)
        .number(run.training)
        .number(double(work.seconds.size()))
        .number(work.steps);
    row.number(work.newton).number(work.force_evaluations).number(work.factorisations).number(work.linear);
    row.number(double(run.not_converged)).number(comparison.seconds());
    row.number(std::ranges::find(members, score) != members.end() ? 1 : 0).text(hexadecimal(run.id));
    text += row.line();
  }
  return text;
}

std::vector<Slope> slopes(const std::vector<const Score*>& scores) {
  std::map<std::string, ErrorsByStep> all;
  for (const Score* score : scores) {
    const CaseRun& run = *score->run;
    if (run.which.axis != Axis::time || !score->time || !score->resolved || score->time->rms > meaningful) continue;
    ErrorsByStep& series = all[run.which.settings.front().second];
    series.order = run.order;
    series.steps.push_back(run.step);
    series.errors.push_back(score->time->rms);
  }
  std::vector<Slope> result;
  for (const auto& [integrator, series] : all)
    if (series.steps.size() >= 2) result.push_back({integrator, series.order, finest_slope(series)});
  return result;
}

}  // namespace app
