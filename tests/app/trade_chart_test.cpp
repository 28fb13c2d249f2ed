// The diagram of a trade, through the data that are drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/trade/chart_layout.h"
#include "app/trade/plot.h"
#include "tests/app/temporary_folder.h"

namespace app {
namespace {

namespace fs = std::filesystem;

// Runs with known times and errors of a scene that is 0.5 m in 100 pixels for each percent.
struct Runs {
  std::deque<CaseRun> runs;
  std::deque<Score> scores;

  Score& add(const std::string& label, Axis axis, const std::string& integrator, int fps, double seconds,
             double error) {
    CaseRun& run = runs.emplace_back();
    run.which = {label, axis, {}};
    if (!integrator.empty()) run.which.settings = {{"time.integrator", integrator}};
    run.status = CaseStatus::done;
    run.step = 1.0 / fps;
    run.work.seconds = {seconds};
    Score& score = scores.emplace_back();
    score.run = &run;
    score.seconds = seconds;
    score.time = Apart{error, 2 * error, 1000 * error};
    score.bound = {error + 1e-4, 2 * error, 1000 * error};
    return score;
  }
  Diagram diagram() const {
    Diagram all{"a \"scene\"", {Goal::Kind::error, 0.01, "an error of 1%"}, {}, 1e-4, 0, nullptr, nullptr};
    for (const Score& score : scores) all.scores.push_back(&score);
    return all;
  }
};

Runs known_runs() {
  Runs all;
  all.add("the scene", Axis::scene, "", 60, 0.5, 0.03);
  for (const int n : {1, 2, 4}) {
    const std::string step = " h=1/" + std::to_string(30 * n);
    all.add("backward-euler" + step, Axis::time, "backward-euler", 30 * n, 0.1 * n, 0.08 / n);
    all.add("tr-bdf2" + step, Axis::time, "tr-bdf2", 30 * n, 0.2 * n, 0.02 / (n * n));
  }
  all.add("tr-bdf2 h=1/480", Axis::reference, "tr-bdf2", 480, 3, 0);
  Score& failed = all.add("central-difference h=auto", Axis::time, "central-difference", 4000, 0.03, 0);
  all.runs.back().status = CaseStatus::failed;
  all.runs.back().reason = "step 12, t = 0.03 s, element 7: the forces are not finite";
  failed.time.reset();
  return all;
}

const Line* line_named(const Chart& chart, const std::string& title) {
  const auto found = std::ranges::find(chart.lines, title, &Line::title);
  return found == chart.lines.end() ? nullptr : &*found;
}

const Dot* dot_labelled(const Chart& chart, const std::string& label) {
  for (const Line& line : chart.lines)
    for (const Dot& dot : line.dots)
      if (dot.label == label) return &dot;
  return nullptr;
}

TEST(Chart, HasALineForEachSchemeAndItsStepsAtThePoints) {
  const Runs runs = known_runs();
  const Chart chart = make_chart(runs.diagram(), ErrorShown::time);
  const Line* const line = line_named(chart, "tr-bdf2");
  ASSERT_TRUE(line);
  std::vector<std::string> labels;
  for (const Dot& dot : line->dots) labels.push_back(dot.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"1/30", "1/60", "1/120", "1/480"}));
  EXPECT_DOUBLE_EQ(line->dots[1].error, 0.5);  // percent
  EXPECT_DOUBLE_EQ(chart.pixels, 10);          // for each of them
  EXPECT_DOUBLE_EQ(chart.target, 1);
  EXPECT_TRUE(dot_labelled(chart, "the scene"));
  ASSERT_EQ(chart.failures.size(), 1U);
  EXPECT_NE(chart.failures[0].text.find("central-difference h=auto: the forces are not finite"), std::string::npos);
}

// Whatever its error is, the advised setting is drawn: below what the reference can tell it lies on the edge of that.
TEST(Chart, ShowsAnAdvicedPointThatTheReferenceCannotTellApart) {
  Runs runs = known_runs();
  const Score& advised = runs.add("sdirk2 h=1/120, tolerance 1e-3", Axis::rest, "sdirk2", 120, 0.9, 3e-5);
  const Score& found = runs.add("found", Axis::rest, "sdirk2", 120, 40, 3e-5);
  Diagram diagram = runs.diagram();
  diagram.advised = &advised;
  diagram.found = &found;
  const Chart chart = make_chart(diagram, ErrorShown::time);
  const Dot* const dot = dot_labelled(chart, "advice");
  ASSERT_TRUE(dot);
  EXPECT_TRUE(dot->below);
  EXPECT_DOUBLE_EQ(dot->error, chart.floor);
  EXPECT_DOUBLE_EQ(chart.floor, 100 * told_apart * 1e-4);
  EXPECT_TRUE(chart.seconds.holds(dot->seconds));
  EXPECT_TRUE(chart.seconds.holds(40)) << "the run that checked it";
  EXPECT_TRUE(chart.error.holds(dot->error));
  const std::string script = plot_script(chart, "out/trade");
  EXPECT_NE(script.find("0.9 0.02 # sdirk2 h=1/120, tolerance 1e-3, below\n"), std::string::npos) << script;
  EXPECT_NE(script.find("set label 'advice'"), std::string::npos);
}

TEST(Chart, HoldsEverythingThatIsDrawn) {
  Runs runs = known_runs();
  for (const auto kind : {Goal::Kind::error, Goal::Kind::pixels, Goal::Kind::time, Goal::Kind::knee}) {
    Diagram diagram = runs.diagram();
    diagram.goal = {kind, kind == Goal::Kind::time ? 1e-3 : kind == Goal::Kind::pixels ? 200 : 0.5, ""};
    const Chart chart = make_chart(diagram, ErrorShown::time);
    for (const Line& line : chart.lines)
      for (const Dot& dot : line.dots) {
        EXPECT_TRUE(chart.seconds.holds(dot.seconds)) << dot.of;
        EXPECT_TRUE(chart.error.holds(dot.error)) << dot.of;
      }
    EXPECT_TRUE(chart.seconds.holds(1)) << "real time";
    EXPECT_TRUE(chart.target == 0 || chart.error.holds(chart.target));
    EXPECT_TRUE(chart.budget == 0 || chart.seconds.holds(chart.budget));
    EXPECT_EQ(chart.target > 0, kind == Goal::Kind::error || kind == Goal::Kind::pixels);
    EXPECT_EQ(chart.budget > 0, kind == Goal::Kind::time);
    for (const Failure& failure : chart.failures) EXPECT_TRUE(chart.seconds.holds(failure.seconds));
  }
}

// Text is inside the picture and over no other text; of the names none is missing.
TEST(Chart, WritesNothingOverAnythingElse) {
  const Runs runs = known_runs();
  Diagram diagram = runs.diagram();
  diagram.advised = diagram.scores[4];
  const ChartLayout layout = lay_out(make_chart(diagram, ErrorShown::time));
  std::vector<std::string> names;
  for (const PlacedText& text : layout.texts) names.push_back(text.text);
  for (const char* needed : {"real time", "target", "below", "the scene", "advice", "order 1", "order 2", "1/30"})
    EXPECT_NE(std::ranges::find(names, needed), names.end()) << needed;
  for (const PlacedText& one : layout.texts) {
    EXPECT_GE(one.x, axes_left);
    EXPECT_LE(one.x, axes_right);
    for (const PlacedText& other : layout.texts)
      if (&one != &other) {
        EXPECT_FALSE(std::abs(one.y - other.y) < small_letters / 2 && std::abs(one.x - other.x) < small_letters)
            << one.text << " / " << other.text;
      }
  }
  ASSERT_EQ(layout.triangles.size(), 2U);
  for (const SlopeTriangle& t : layout.triangles) EXPECT_NEAR(std::log(t.high) / std::log(t.wide), t.order, 1e-9);
}

double luminance(const std::string& colour, double white) {
  const double weights[] = {0.2126, 0.7152, 0.0722};
  double sum = 0;
  for (int c = 0; c < 3; ++c) {
    const double ink = std::stoi(colour.substr(1 + 2 * c, 2), nullptr, 16) / 255.0, x = (1 - white) * ink + white;
    sum += weights[c] * (x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4));
  }
  return sum;
}

// WCAG 2: (L_white + 0.05) / (L_ink + 0.05).
TEST(Ink, IsLegibleOnAWashedOutProjector) {
  const std::vector<std::string> all = inks();
  for (const std::string& ink : all) EXPECT_GE(1.05 / (luminance(ink, 0.4) + 0.05), 4.5) << ink;
  for (const char* name : {"tr-bdf2", "backward-euler", "sdirk2", "something else"})
    EXPECT_NE(std::ranges::find(all, ink_of(name).colour), all.end()) << name;
}

// The whole script of known runs, as it is stored; RITZ_STORE_GOLDEN=1 stores it anew.
TEST(Chart, IsDrawnAsItIsStored) {
  const fs::path stored = fs::path(RITZ_SOURCE_DIR) / "tests/data/golden/trade.gp";
  Runs runs = known_runs();
  Diagram diagram = runs.diagram();
  diagram.advised = diagram.scores[4];
  const std::string script = plot_script(make_chart(diagram, ErrorShown::time), "out/trade");
  if (std::getenv("RITZ_STORE_GOLDEN")) write_all(stored, script);
  EXPECT_EQ(script, read_all(stored));
}

TEST(Chart, OfSeveralScenesHasTheirFronts) {
  const Runs one = known_runs(), other = known_runs();
  Diagram second = other.diagram();
  second.name = "another";
  const Chart chart = make_chart({one.diagram(), second}, ErrorShown::time);
  EXPECT_EQ(chart.title, "a \"scene\" / another");
  ASSERT_EQ(chart.lines.size(), 2U);
  EXPECT_EQ(chart.lines[1].title, "another");
  EXPECT_EQ(chart.lines[0].dots.size(), make_chart(one.diagram(), ErrorShown::time).front.size());
}

}  // namespace
}  // namespace app
