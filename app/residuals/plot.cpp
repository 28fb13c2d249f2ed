#include "app/residuals/plot.h"

#include <algorithm>
#include <map>

#include "app/base/gnuplot.h"
#include "app/base/number_text.h"
#include "app/base/text.h"
#include "app/residuals/orders.h"

namespace app {
namespace {

using sim::residual::Errors;
using sim::residual::Real;

constexpr int most_shown_terms = 4;  // the largest n up to it is drawn: curves can still be told apart
constexpr int plot_cells = 400;      // of a curve
constexpr Real round_off = 1e-16L;   // errors below it are not drawn

// A line of a panel; "" has no title.
struct Curve {
  std::string title, style;
  std::vector<std::pair<Real, Real>> points;
};

struct PlotPanel {
  std::string settings;
  std::vector<Curve> curves;
  bool logarithmic = false;
};

// Room about a single value, of which gnuplot would make a range with a warning; else the range is its own choice.
std::string range_text(const PlotPanel& panel, char axis, Real std::pair<Real, Real>::*of) {
  const Real first = panel.curves.front().points.front().*of;
  for (const Curve& curve : panel.curves)
    for (const auto& point : curve.points)
      if (point.*of != first) return formatted("set %crange [*:*]\n", axis);
  return panel.logarithmic ? formatted("set %crange [%Lg:%Lg]\n", axis, first / 2, first * 2)
                           : formatted("set %crange [%Lg:%Lg]\n", axis, first - 1, first + 1);
}

// One colour a method [Okabe & Ito], and one dash pattern a basis.
std::string method_style(const std::string& method) {
  const std::map<std::string, std::string> colours = {{"collocation-equal", "#e69f00"},
                                                      {"collocation-gauss", "#d55e00"},
                                                      {"least-squares", "#009e73"},
                                                      {"galerkin", "#0072b2"}};
  const auto found = colours.find(method);
  return "lw 2 lc rgb '" + (found == colours.end() ? "#cc79a7" : found->second) + "'";
}

// Ritz's curves lie on Galerkin's: dashes and rings let both be seen.
bool is_ritz(const std::string& method) {
  return method.starts_with("ritz");
}

int shown_terms(const ResidualStudy& study) {
  int shown = study.file.n.front();
  for (const int n : study.file.n)
    if (n <= most_shown_terms) shown = n;
  return shown;
}

template <class F>
Curve curve_of(const std::string& title, const std::string& style, const F& y) {
  Curve curve{title, style, {}};
  for (int i = 0; i <= plot_cells; ++i) {
    const Real x = Real(i) / plot_cells;
    curve.points.emplace_back(x, y(x));
  }
  return curve;
}

// u above, what is left of the equation below.
std::pair<PlotPanel, PlotPanel> basis_panels(const ResidualStudy& study, const sim::residual::Basis& basis, int n) {
  const sim::residual::Problem& problem = study.file.problem;
  const std::string name(basis.name);
  PlotPanel above{"set title '" + std::to_string(n) + " " + name + "'\nset ylabel 'u'\n", {}},
      below{"set title ''\nset ylabel '" + std::string(basis.smooth ? "residual L u_n - f" : "error u_n - u") + "'\n",
            {}};
  above.curves.push_back(curve_of(study.file.exact_is_computed() ? "u, computed" : "u", "lines lw 5 lc rgb '#bbbbbb'",
                                  [&](Real x) { return problem.exact(x).value; }));
  for (const Attempt& attempt : study.attempts) {
    if (attempt.basis() != basis.name || attempt.n() != n) continue;
    const std::string style = "lines " + method_style(attempt.method) + (is_ritz(attempt.method) ? " dt 2" : "");
    above.curves.push_back(curve_of(attempt.method, style, [&](Real x) { return attempt.u.at(x).value; }));
    below.curves.push_back(curve_of("", style, [&](Real x) {
      const auto u = attempt.u.at(x);
      return basis.smooth ? apply(problem, x, u) - problem.f(x).value : u.value - problem.exact(x).value;
    }));
  }
  return {above, below};
}

// An error over n; the title tells the last order.
PlotPanel convergence_panel(const ResidualStudy& study, const std::string& title,
                            std::optional<Real> (*error)(const Errors&), std::optional<Real> Orders::*order) {
  std::map<std::string_view, int> dashes;
  PlotPanel panel{"set logscale xy\nset format y '10^{%T}'\nset xlabel 'n'\nset ylabel '" + title + "'\n", {}, true};
  const std::vector<Orders> all = orders_of(study);
  for (const Attempt& attempt : study.attempts) {
    const int dash = dashes.emplace(attempt.basis(), static_cast<int>(dashes.size()) + 1).first->second;
    const std::string name = std::string(attempt.basis()) + " " + attempt.method;
    const auto value = error(attempt.errors);
    if (!value || !(*value > round_off)) continue;
    if (panel.curves.empty() || !panel.curves.back().title.starts_with(name + ":"))
      panel.curves.push_back({name + ":",
                              std::string("linespoints ") +
                                  (is_ritz(attempt.method) ? "pt 6 ps 1.1 dt " : "pt 7 ps 0.5 dt ") +
                                  std::to_string(dash) + " " + method_style(attempt.method),
                              {}});
    Curve& curve = panel.curves.back();
    curve.points.emplace_back(attempt.n(), *value);
    for (const Orders& orders : all)
      if (orders.to == &attempt && orders.*order) curve.title = name + formatted(": %.2Lf", *(orders.*order));
  }
  return panel;
}

// A panel as gnuplot reads it; its data go before everything.
std::string panel_text(const PlotPanel& panel, int number, std::string& data) {
  std::string plot;
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    const Curve& curve = panel.curves[i];
    const std::string name = "$p" + std::to_string(number) + "c" + std::to_string(i);
    data += name + " << EOD\n";
    for (const auto& [x, y] : curve.points) {
      append_number(data, static_cast<double>(x));
      data += ' ';
      append_number(data, static_cast<double>(y));
      data += '\n';
    }
    data += "EOD\n";
    plot += (plot.empty() ? "plot " : ", \\\n  ") + name + " using 1:2 with " + curve.style +
            (curve.title.empty() ? " notitle" : " title " + gnuplot_quoted(curve.title));
  }
  // An empty cell keeps the grid of panels.
  if (plot.empty()) return "set multiplot next\n";
  using Point = std::pair<Real, Real>;
  return panel.settings + range_text(panel, 'x', &Point::first) + range_text(panel, 'y', &Point::second) + plot + "\n";
}

// One picture of panels in rows, as SVG and as PNG.
std::string picture_text(const std::string& title, const std::filesystem::path& base, int columns,
                         const std::vector<PlotPanel>& panels, int first, int height, std::string& data) {
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  std::string drawing = formatted("set multiplot layout %d,%d title ", rows, columns) + gnuplot_quoted(title) +
                        " noenhanced\nset key below noenhanced samplen 2 font ',10'\nset grid\n";
  for (std::size_t i = 0; i < panels.size(); ++i) drawing += panel_text(panels[i], first + static_cast<int>(i), data);
  drawing += "unset multiplot\n";
  const auto output = [&](const std::string& terminal, const std::string& extension) {
    return "reset\nset terminal " + terminal +
           formatted(" size %d,%d\nset output ", 480 * columns, 60 + height * rows) +
           gnuplot_quoted(base.string() + extension) + "\n" + drawing;
  };
  return output("svg font 'sans,12' background 'white'", ".svg") + output("pngcairo font 'sans,12'", ".png");
}

}  // namespace

std::string residual_plot_script(const ResidualStudy& study, const std::filesystem::path& base) {
  const int n = shown_terms(study), columns = static_cast<int>(study.file.bases.size());
  std::vector<PlotPanel> above, below;
  for (const auto* const basis : study.file.bases) {
    auto [upper, lower] = basis_panels(study, *basis, n);
    above.push_back(std::move(upper));
    below.push_back(std::move(lower));
  }
  above.insert(above.end(), below.begin(), below.end());
  const std::vector<PlotPanel> convergence = {
      convergence_panel(
          study, "L2 error", [](const Errors& e) { return std::optional(e.L2); }, &Orders::L2),
      convergence_panel(
          study, "H1 seminorm of the error", [](const Errors& e) { return std::optional(e.H1_seminorm); }, &Orders::H1),
      convergence_panel(
          study, "L2 norm of the residual", [](const Errors& e) { return e.residual_L2; }, &Orders::residual)};
  std::string data,
      pictures = picture_text(study.file.name, base.string() + "-solutions", columns, above, 0, 420, data);
  pictures += picture_text(study.file.name + ": errors over n, with the order from the last n but one to the last",
                           base.string() + "-convergence", 3, convergence, static_cast<int>(above.size()), 640, data);
  return data + pictures;
}

}  // namespace app
