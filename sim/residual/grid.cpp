#include "sim/residual/grid.h"

#include <array>
#include <cmath>
#include <functional>
#include <sstream>

#include "sim/residual/legendre.h"
#include "sim/residual/rule.h"

namespace sim::residual {
namespace {

constexpr int panel_points = 20;     // a panel
constexpr int deepest_allowed = 30;  // halvings
constexpr int most_panels = 4000;    // of all
constexpr int fewest_panels = 8;
constexpr Real round_off = 1e-15L;  // of the largest value

struct Part {
  const char* key;
  std::function<Real(Real)> at;
};

std::vector<Part> parts_of(const Problem& problem) {
  const auto value = [](const Function& g) { return [&g](Real x) { return g(x).value; }; };
  const auto slope = [](const Function& g) { return [&g](Real x) { return g(x).slope; }; };
  std::vector<Part> parts = {{"k", value(problem.k)},
                             {"k", slope(problem.k)},
                             {"a", value(problem.a)},
                             {"q", value(problem.q)},
                             {"f", value(problem.f)}};
  if (problem.exact) {
    parts.push_back({"exact", value(problem.exact)});
    parts.push_back({"exact", slope(problem.exact)});
  }
  return parts;
}

struct Panel {
  Real low = 0, high = 0;
  int depth = 0;
};

// What a panel shows of a function: its largest absolute value, and how much of it the highest two polynomials carry.
struct View {
  Real size = 0, tail = 0;
};

class Sieve {
 public:
  Sieve() : rule_(gauss_legendre(panel_points)) {
    for (int p = 0; p < panel_points; ++p)
      for (int m = 0; m < 2; ++m) {
        // c_m = (2m + 1)/2 int g P_m dt
        const int degree = panel_points - 1 - m;
        tail_(m, p) = rule_.weight[p] * (2 * degree + 1) / 2 * legendre(degree, rule_.t[p]).value;
      }
  }

  View look(const Part& part, const Panel& panel) const {
    View view;
    Eigen::Matrix<Real, 2, 1> tail = {0, 0};
    for (int p = 0; p < panel_points; ++p) {
      const Real x = (panel.low + panel.high + rule_.t[p] * (panel.high - panel.low)) / 2, value = part.at(x);
      if (!std::isfinite(value)) {
        std::ostringstream text;
        text << part.key << " or its slope is " << value << " at x = " << x << ": must be a finite number";
        throw ProblemError(part.key, text.str());
      }
      view.size = std::max(view.size, std::abs(value));
      tail += tail_.col(p) * value;
    }
    view.tail = tail.cwiseAbs().maxCoeff();
    return view;
  }

 private:
  Rule rule_;
  Eigen::Matrix<Real, 2, panel_points> tail_;
};

// The first panels: a multiple of the cells of n hats.
std::vector<Panel> first_panels(int n) {
  const int cells = n + 1, count = cells * ((fewest_panels + cells - 1) / cells);
  std::vector<Panel> panels;
  for (int i = 0; i < count; ++i) panels.push_back({Real(i) / count, Real(i + 1) / count, 0});
  return panels;
}

// A function that is as large as its panel is narrow has an integral without end.
void refuse_singular(const Part& part, const Panel& panel, const View& view, Real scale) {
  if (view.size * (panel.high - panel.low) < Real(1e-3) * scale) return;
  std::ostringstream text;
  text << part.key << " is not integrable near x = " << panel.low << ": must be bounded between 0 and 1";
  throw ProblemError(part.key, text.str());
}

[[noreturn]] void refuse_unresolved(const Part& part) {
  throw ProblemError(part.key, std::string(part.key) + " is not resolved by " + std::to_string(most_panels) +
                                   " panels of " + std::to_string(panel_points) +
                                   " points: must be bounded, and must not swing so fast");
}

// Halves the panels on which this function is not resolved.
void refine(const Sieve& sieve, const Part& part, std::vector<Panel>& panels) {
  Real scale = 0, mean = 0;
  for (const Panel& panel : panels) {
    const Real size = sieve.look(part, panel).size;
    scale = std::max(scale, size);
    mean += size * (panel.high - panel.low);
  }
  std::vector<Panel> fine, waiting(panels.rbegin(), panels.rend());
  while (!waiting.empty()) {
    const Panel panel = waiting.back();
    waiting.pop_back();
    const View view = sieve.look(part, panel);
    const bool deepest = panel.depth == deepest_allowed, resolved = view.tail <= round_off * std::max(scale, view.size);
    if (deepest && !resolved) refuse_singular(part, panel, view, mean);
    if (deepest || resolved) {
      fine.push_back(panel);
      continue;
    }
    if (fine.size() + waiting.size() > most_panels) refuse_unresolved(part);
    const Real middle = (panel.low + panel.high) / 2;
    waiting.push_back({middle, panel.high, panel.depth + 1});
    waiting.push_back({panel.low, middle, panel.depth + 1});
  }
  panels = std::move(fine);
}

}  // namespace

std::vector<Real> make_panels(const Problem& problem, int n) {
  const Sieve sieve;
  std::vector<Panel> panels = first_panels(n);
  for (const Part& part : parts_of(problem)) refine(sieve, part, panels);
  std::vector<Real> ends = {0};
  for (const Panel& panel : panels) ends.push_back(panel.high);
  return ends;
}

Grid gauss_grid(const Problem& problem, int n) {
  const std::vector<Real> ends = make_panels(problem, n);
  const Rule rule = gauss_legendre(panel_points);
  const auto count = static_cast<Eigen::Index>(ends.size()) - 1;
  Grid grid{Vector(count * panel_points), Vector(count * panel_points)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Real half = (ends[i + 1] - ends[i]) / 2;
    grid.x.segment(i * panel_points, panel_points) = Vector::Constant(panel_points, ends[i] + half) + half * rule.t;
    grid.weight.segment(i * panel_points, panel_points) = half * rule.weight;
  }
  return grid;
}

}  // namespace sim::residual
