#include "app/trade/chart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "app/base/text.h"
#include "sim/study/front.h"

namespace app {
namespace {

constexpr double percent_of = 100;
constexpr double failed_error = 1;  // body sizes: no result any more

const std::optional<Apart>& error_shown(const Score& score, ErrorShown shown) {
  return shown == ErrorShown::total ? score.total : score.time;
}

bool failed(const Score& score) {
  const auto& error = score.total ? score.total : score.time;
  return score.run->status == CaseStatus::failed || (error && !(error->rms < failed_error));
}

// "1/120" of a step of 1/120 s; "auto" where it is what stability needs.
std::string step_label(const CaseRun& run) {
  for (const auto& [key, value] : run.which.settings)
    if (key == "time.substeps" && value == "\"auto\"") return "auto";
  return run.step > 0 ? formatted("1/%.0f", 1 / run.step) : "";
}

class Maker {
 public:
  Maker(const Diagram& diagram, ErrorShown shown)
      : diagram_(diagram),
        shown_(shown),
        floor_(percent_of * told_apart *
               (shown == ErrorShown::total ? diagram.total_uncertainty : diagram.uncertainty)) {}

  double floor() const { return floor_; }

  std::optional<Dot> dot(const Score& score, const std::string& label) const {
    const auto& error = error_shown(score, shown_);
    if (!error || failed(score) || !(score.seconds > 0)) return {};
    const double found = percent_of * error->rms;
    return Dot{score.seconds, std::max(found, floor_), label, score.run->which.label, found < floor_};
  }

  std::vector<Line> lines() const {
    std::map<std::string, Line> schemes;
    Line meshes{"other meshes", mesh_ink, false, 1, {}}, rest{"other settings", setting_ink, false, 0.7, {}};
    for (const Score* score : diagram_.scores) {
      const TradeCase& which = score->run->which;
      const bool steps = which.axis == Axis::time || which.axis == Axis::reference;
      const auto point = dot(*score, steps ? step_label(*score->run) : "");
      if (!point || which.axis == Axis::scene) continue;
      if (!steps) {
        (which.axis == Axis::mesh ? meshes : rest).dots.push_back(*point);
        continue;
      }
      const std::string& name = which.settings.front().second;
      Line& line = schemes[name];
      line.title = name;
      line.ink = ink_of(name);
      line.dots.push_back(*point);
    }
    std::vector<Line> all = {meshes, rest};
    for (auto& [name, line] : schemes) {
      std::ranges::sort(line.dots, {}, &Dot::seconds);
      all.push_back(std::move(line));
    }
    add_marked(all);
    std::erase_if(all, [](const Line& line) { return line.dots.empty(); });
    return all;
  }

  // Of what is drawn here, those that nothing beats in both.
  std::vector<Dot> front() const {
    std::vector<Dot> dots;
    std::vector<sim::WorkError> points;
    for (const Score* score : diagram_.scores)
      if (const auto point = dot(*score, "")) {
        dots.push_back(*point);
        points.push_back({point->seconds, point->error});
      }
    std::vector<Dot> members;
    for (const int k : sim::front(points)) members.push_back(dots[k]);
    return members;
  }

  // The median of what is known of both.
  double pixels_per_percent() const {
    std::vector<double> ratios;
    for (const Score* score : diagram_.scores)
      if (const auto& error = error_shown(*score, shown_); error && error->rms > 0)
        ratios.push_back(error->pixels / (percent_of * error->rms));
    if (ratios.empty()) return 0;
    std::ranges::sort(ratios);
    return ratios[ratios.size() / 2];
  }

  std::vector<Failure> failures() const {
    std::vector<Failure> all;
    for (const Score* score : diagram_.scores) {
      if (!failed(*score) || !(score->seconds > 0)) continue;
      const std::string& reason = score->run->reason;
      const std::size_t last = reason.rfind(": ");
      const std::string cause = last == std::string::npos ? reason : reason.substr(last + 2);
      all.push_back(
          {score->seconds, score->run->which.label + ": " + (cause.empty() ? "its error is the body's size" : cause)});
    }
    return all;
  }

 private:
  void add_marked(std::vector<Line>& all) const {
    const auto add = [&](const Score* score, const std::string& name, const Ink& ink, double size) {
      if (!score) return;
      if (const auto point = dot(*score, name)) all.push_back({"", ink, false, size, {*point}});
    };
    const auto own =
        std::ranges::find_if(diagram_.scores, [](const Score* s) { return s->run->which.settings.empty(); });
    if (own != diagram_.scores.end()) add(*own, "the scene", scene_ink, 2);
    if (diagram_.advised) add(diagram_.advised, "advice", advice_ink, 3);
    add(diagram_.found, "check", check_ink, 2);
  }

  const Diagram& diagram_;
  ErrorShown shown_;
  double floor_;
};

void include(AxisRange& range, double value) {
  range.low = std::min(range.low, value);
  range.high = std::max(range.high, value);
}

// So that nothing lies on the frame; of a single value, a decade about it.
AxisRange widened(const AxisRange& range, double part) {
  if (!(range.low <= range.high)) return {0.1, 10};
  const double decades = std::max(std::log10(range.high / range.low), 1.0), room = std::pow(10.0, part * decades);
  return {range.low / room, range.high * room};
}

void settle_ranges(Chart& chart) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  chart.seconds = chart.error = {infinite, 0};
  const auto add = [&](const std::vector<Dot>& dots) {
    for (const Dot& dot : dots) {
      include(chart.seconds, dot.seconds);
      include(chart.error, dot.error);
    }
  };
  for (const Line& line : chart.lines) add(line.dots);
  add(chart.front);
  for (const Failure& failure : chart.failures) include(chart.seconds, failure.seconds);
  if (chart.seconds.low <= chart.seconds.high) {
    include(chart.seconds, 1);  // real time
    if (chart.budget > 0) include(chart.seconds, chart.budget);
  }
  if (chart.error.low <= chart.error.high) {
    if (chart.target > 0) include(chart.error, chart.target);
    if (chart.floor > 0) include(chart.error, chart.floor);
  }
  chart.seconds = widened(chart.seconds, 0.06);
  chart.error = widened(chart.error, 0.08);
  // Room for its name in what lies below the floor.
  if (chart.floor > 0)
    chart.error.low = std::min(chart.error.low, chart.floor / std::pow(chart.error.high / chart.floor, 0.12));
}

const char* name_of(ErrorShown shown) {
  return shown == ErrorShown::total ? "error against the finest mesh" : "time error on the mesh of the scene";
}

}  // namespace

bool has_errors(const Diagram& diagram, ErrorShown shown) {
  return std::ranges::any_of(diagram.scores,
                             [&](const Score* score) { return error_shown(*score, shown).has_value(); });
}

Chart make_chart(const Diagram& diagram, ErrorShown shown) {
  const Maker maker(diagram, shown);
  Chart chart{diagram.name, name_of(shown), maker.lines(), maker.front(), maker.failures(), {}, {}, {}};
  if (diagram.advised) chart.advice = diagram.advised->run->which.label;
  chart.floor = maker.floor();
  chart.pixels = maker.pixels_per_percent();
  if (diagram.goal.kind == Goal::Kind::error) chart.target = percent_of * diagram.goal.value;
  if (diagram.goal.kind == Goal::Kind::pixels && chart.pixels > 0) chart.target = diagram.goal.value / chart.pixels;
  if (diagram.goal.kind == Goal::Kind::time && diagram.goal.value != 1) chart.budget = diagram.goal.value;
  settle_ranges(chart);
  return chart;
}

Chart make_chart(const std::vector<Diagram>& diagrams, ErrorShown shown) {
  if (diagrams.size() == 1) return make_chart(diagrams.front(), shown);
  const Ink own[] = {ink_of("tr-bdf2"), ink_of("backward-euler"), ink_of("sdirk2")};
  Chart chart;
  chart.error_name = name_of(shown);
  for (std::size_t k = 0; k < diagrams.size(); ++k) {
    const Maker maker(diagrams[k], shown);
    chart.title += (k == 0 ? "" : " / ") + diagrams[k].name;
    chart.lines.push_back({diagrams[k].name, own[k % std::size(own)], true, 1.5, maker.front()});
    chart.floor = std::max(chart.floor, maker.floor());
    chart.pixels = maker.pixels_per_percent();
  }
  settle_ranges(chart);
  return chart;
}

}  // namespace app
