// The diagram of a trade, through the data that are drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/trade/chart_layout.h"
#include "app/trade/plot.h"
#include "sim/time/scheme.h"
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
  for (const char* name : {"set label 'advice'", "set label 'check'", "set label 'the scene'",
                           "set label 'advice: sdirk2 h=1/120, tolerance 1e-3'"})
    EXPECT_NE(script.find(name), std::string::npos) << name;
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

// What a text covers, as the picture's own letters do.
struct Box {
  double left, below, right, above;
};

Box box_of(const PlacedText& text) {
  const double half = (text.large ? large_letters : small_letters) / 2;
  return {text.x, text.y - half, text.x + text_width(text.text, text.large), text.y + half};
}

bool meet(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.below < b.above && b.below < a.above;
}

// Every text is within the axes, and over no other and no point.
void expect_clear(const Chart& chart, const ChartLayout& layout) {
  for (const PlacedText& one : layout.texts) {
    const Box box = box_of(one);
    EXPECT_TRUE(box.left >= axes_left && box.right <= axes_right && box.below >= axes_below && box.above <= axes_above)
        << one.text;
    for (const PlacedText& other : layout.texts)
      if (&one != &other) {
        EXPECT_FALSE(meet(box, box_of(other))) << one.text << " / " << other.text;
      }
    for (const Line& line : chart.lines)
      for (const Dot& dot : line.dots) {
        const double x = pixel_of_seconds(chart, dot.seconds), y = pixel_of_error(chart, dot.error);
        EXPECT_FALSE(meet(box, {x, y, x, y})) << one.text << " over " << dot.of;
      }
  }
}

TEST(Chart, WritesNothingOverAnythingElse) {
  const Runs runs = known_runs();
  Diagram diagram = runs.diagram();
  diagram.advised = diagram.scores[4];
  const Chart chart = make_chart(diagram, ErrorShown::time);
  const ChartLayout layout = lay_out(chart);
  std::vector<std::string> names;
  for (const PlacedText& text : layout.texts) names.push_back(text.text);
  for (const char* needed : {"real time", "target", "below", "the scene", "advice", "order 1", "order 2", "1/30"})
    EXPECT_NE(std::ranges::find(names, needed), names.end()) << needed;
  expect_clear(chart, layout);
  ASSERT_EQ(layout.triangles.size(), 2U);
  for (const SlopeTriangle& t : layout.triangles) EXPECT_NEAR(std::log(t.high) / std::log(t.wide), t.order, 1e-9);
}

// Six schemes whose points all but coincide, with the scene, the advice and its check among them: the three are named,
// beside the heap, and a step stands there once.
TEST(Chart, NamesWhatIsInAHeapAndLabelsItOnce) {
  Runs runs;
  runs.add("the scene", Axis::scene, "", 60, 0.52, 0.02);
  for (const char* name : {"backward-euler", "tr-bdf2", "sdirk2", "bdf2", "trapezoidal", "implicit-midpoint"})
    for (const int n : {1, 2, 4})
      runs.add(std::string(name) + " h=1/" + std::to_string(30 * n), Axis::time, name, 30 * n,
               0.5 * (1 + 0.02 * n + 0.003 * static_cast<double>(runs.scores.size())), 0.02 + 1e-4 * n);
  Diagram diagram = runs.diagram();
  const Score& found = runs.add("found", Axis::rest, "tr-bdf2", 30, 0.53, 0.02);
  diagram.advised = diagram.scores[2];
  diagram.found = &found;
  const Chart chart = make_chart(diagram, ErrorShown::time);
  const ChartLayout layout = lay_out(chart);
  expect_clear(chart, layout);
  for (const char* name : {"the scene", "advice", "check"})
    EXPECT_EQ(std::ranges::count(layout.texts, name, &PlacedText::text), 1) << name;
  for (const char* step : {"1/30", "1/60", "1/120"})
    EXPECT_LE(std::ranges::count(layout.texts, step, &PlacedText::text), 1) << step;
}

// Linear red, green and blue of "#rrggbb" mixed with so much white.
std::array<double, 3> linear(const std::string& colour, double white) {
  std::array<double, 3> all{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double ink = std::stoi(colour.substr(1 + 2 * c, 2), nullptr, 16) / 255.0, x = (1 - white) * ink + white;
    all[c] = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  }
  return all;
}

double luminance(const std::string& colour, double white) {
  const auto [r, g, b] = linear(colour, white);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

// CIE L*a*b* with the white of sRGB: the distance of two colours of which 2.3 is just seen.
std::array<double, 3> lab(const std::string& colour, double white) {
  const auto [r, g, b] = linear(colour, white);
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  const double x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505), y = f(0.2126 * r + 0.7152 * g + 0.0722 * b),
               z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double difference(const std::string& one, const std::string& other, double white) {
  const auto a = lab(one, white), b = lab(other, white);
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

constexpr double washed = 0.4;  // of white, on a washed-out projector

// WCAG 2: (L_white + 0.05) / (L_ink + 0.05).
TEST(Ink, IsLegibleOnAWashedOutProjector) {
  for (const std::string& ink : dark_colours()) EXPECT_GE(1.05 / (luminance(ink, washed) + 0.05), 4.5) << ink;
}

// No two lines share a colour or a mark: a colour is ten times what is just seen from every other, washed out too, and
// a mark is another shape, or hollow where the other is filled. None has the square of the scene or the advice's ring.
TEST(Ink, TellsEverySchemeApartByColourAndByMark) {
  for (const sim::Scheme& scheme : sim::schemes()) {
    if (scheme.is_static) continue;
    const Ink ink = ink_of(scheme.name);
    EXPECT_NE(ink.mark, setting_ink.mark) << scheme.name << " has no row";
    for (const SchemeInk& other : scheme_inks) {
      if (other.integrator == scheme.name) continue;
      for (const double white : {0.0, washed})
        EXPECT_GE(difference(ink.bright, other.ink.bright, white), 23) << scheme.name << " / " << other.integrator;
      EXPECT_FALSE(ink.mark == other.ink.mark && ink.hollow == other.ink.hollow)
          << scheme.name << " / " << other.integrator;
    }
    for (const Ink& own : {mesh_ink, setting_ink, scene_ink, advice_ink, check_ink})
      EXPECT_FALSE(ink.mark == own.mark && ink.hollow == own.hollow) << scheme.name;
    EXPECT_EQ(ink.dashes, scheme.is_explicit() ? 3 : scheme.order == 1 ? 2 : 1) << scheme.name;
  }
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
