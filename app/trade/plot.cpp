#include "app/trade/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "app/base/gnuplot.h"
#include "app/base/number_text.h"
#include "app/trade/advice.h"

namespace app {
namespace {

// Which error a panel shows.
using ErrorOf = std::optional<Apart> Score::*;

struct Dot {
  double seconds = 0, error = 0;
  std::string label;
};

struct Series {
  std::string title, style;
  std::vector<Dot> dots;
  bool on_y2 = false;  // at heights of the picture instead of errors
};

constexpr double failed_error = 1;  // body sizes: no result any more
constexpr double margin = 0.97;     // where failures are drawn, as a share of the height

// One colour for each integrator, in every diagram [Okabe & Ito, darker yellow, and two more].
std::string integrator_style(const std::string& name) {
  const std::map<std::string, std::string> colours = {
      {"backward-euler", "#d55e00"}, {"linearly-implicit", "#e69f00"}, {"bdf2", "#009e73"},
      {"trapezoidal", "#56b4e9"},    {"implicit-midpoint", "#0072b2"}, {"sdirk2", "#cc79a7"},
      {"tr-bdf2", "#000000"},        {"symplectic-euler", "#b8a800"},  {"central-difference", "#8b5a2b"}};
  const auto found = colours.find(name);
  return "linespoints lw 1.5 pt 7 ps 0.6 lc rgb '" + (found == colours.end() ? "#777777" : found->second) + "'";
}

bool failed(const Score& score) {
  const auto& error = score.total ? score.total : score.time;
  return score.run->status == CaseStatus::failed || (error && !(error->rms < failed_error));
}

// A point of a panel, where it has one above what is certain.
std::optional<Dot> dot(const Score& score, ErrorOf error, double least) {
  const std::optional<Apart>& value = score.*error;
  if (!value || score.run->which.axis == Axis::reference || failed(score) || !(value->rms > least)) return {};
  return Dot{score.seconds(), value->rms, score.run->which.label};
}

std::vector<Series> series_of(const Diagram& diagram, ErrorOf error, double least) {
  std::map<std::string, Series> lines;
  Series meshes{"other meshes", "points pt 6 ps 0.9 lc rgb '#555555'", {}},
      rest{"other settings", "points pt 2 ps 0.5 lc rgb '#999999'", {}},
      own{"the scene as it is", "points pt 9 ps 1.4 lc rgb '#cc0000'", {}},
      advised{"advice", "points pt 6 ps 2.4 lw 2 lc rgb '#cc0000'", {}};
  for (const Score* score : diagram.scores) {
    const auto point = dot(*score, error, least);
    if (!point) continue;
    const TradeCase& which = score->run->which;
    if (score == diagram.advised) advised.dots.push_back(*point);
    if (which.axis == Axis::time) {
      const std::string name = which.settings.front().second;
      lines[name].title = name;
      lines[name].style = integrator_style(name);
      lines[name].dots.push_back(*point);
    } else {
      (which.axis == Axis::mesh ? meshes : which.axis == Axis::scene ? own : rest).dots.push_back(*point);
    }
  }
  std::vector<Series> all;
  for (auto& [name, series] : lines) {
    std::ranges::sort(series.dots, {}, &Dot::seconds);
    all.push_back(std::move(series));
  }
  for (Series* const series : {&meshes, &rest, &own, &advised}) all.push_back(std::move(*series));
  return all;
}

Series front_series(const Diagram& diagram, ErrorOf error, double least, const std::string& title,
                    const std::string& style) {
  Series front{title, style, {}};
  for (const Score* score : front_of(diagram.scores))
    if (const auto point = dot(*score, error, least)) front.dots.push_back(*point);
  return front;
}

Series failures(const Diagram& diagram) {
  Series series{"failed", "points pt 2 ps 1 lw 2 lc rgb '#cc0000'", {}, true};
  for (const Score* score : diagram.scores)
    if (failed(*score) && score->seconds() > 0)
      series.dots.push_back({score->seconds(), margin, score->run->which.label});
  return series;
}

std::vector<Series> panel(const std::vector<Diagram>& diagrams, ErrorOf error, bool with_front) {
  const auto least = [&](const Diagram& d) { return error == &Score::time ? d.uncertainty : d.total_uncertainty; };
  if (diagrams.size() > 1) {
    std::vector<Series> fronts;
    for (const Diagram& d : diagrams)
      fronts.push_back(front_series(d, error, least(d), d.name, "linespoints lw 2 pt 7 ps 0.7"));
    return fronts;
  }
  const Diagram& only = diagrams.front();
  std::vector<Series> all;
  if (with_front) all.push_back(front_series(only, error, least(only), "front", "lines lw 7 lc rgb '#66ddaa33'"));
  for (Series& series : series_of(only, error, least(only))) all.push_back(std::move(series));
  all.push_back(failures(only));
  return all;
}

std::string data_block(const std::string& name, const Series& series) {
  std::string text = name + " << EOD\n";
  for (const Dot& dot : series.dots) {
    append_number(text, dot.seconds);
    text += ' ';
    append_number(text, dot.error);
    text += " # " + dot.label + '\n';
  }
  return text + "EOD\n";
}

// An axis of a single value is given room; gnuplot scales all others by itself.
std::string range_of(const std::vector<Series>& all, const char* axis, double Dot::*of) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const Series& series : all) {
    if (of == &Dot::error && series.on_y2) continue;
    for (const Dot& dot : series.dots) {
      low = std::min(low, dot.*of);
      high = std::max(high, dot.*of);
    }
  }
  std::string text = std::string("set ") + axis + "range [";
  if (low < high) return text + "*:*]\n";
  append_number(text, low / 3);
  text += ':';
  append_number(text, high * 3);
  return text + "]\n";
}

// A panel as gnuplot reads it; its data go before everything.
std::string plot_command(const std::vector<Series>& all, const std::string& prefix, std::string& data) {
  std::string plot;
  int block = 0;
  for (const Series& series : all) {
    if (series.dots.empty()) continue;
    const std::string name = "$" + prefix + std::to_string(++block);
    data += data_block(name, series);
    plot += (plot.empty() ? "plot " : ", \\\n  ") + name + " using 1:2 with " + series.style +
            (series.on_y2 ? " axes x1y2" : "") + " title " + gnuplot_quoted(series.title);
  }
  if (plot.empty()) return plot;
  return range_of(all, "x", &Dot::seconds) + range_of(all, "y", &Dot::error) + plot;
}

}  // namespace

std::string plot_script(const std::vector<Diagram>& diagrams, const std::filesystem::path& base) {
  std::string data, title;
  for (const Diagram& diagram : diagrams) title += (title.empty() ? "" : " / ") + diagram.name;
  const std::string total = plot_command(panel(diagrams, &Score::total, true), "total", data),
                    time = plot_command(panel(diagrams, &Score::time, total.empty()), "time", data);
  if (time.empty() && total.empty()) return "# nothing was measured that could be drawn\n";
  const int panels = (time.empty() ? 0 : 1) + (total.empty() ? 0 : 1);
  const std::string settings =
      "set logscale xy\nset format y '10^{%T}'\nset xlabel 'wall time per simulated second [s]'\nset grid\n"
      "set y2range [0:1]\nset bmargin 9\nset key below noenhanced samplen 2 font ',10'\n";
  std::string drawing =
      "set multiplot layout 1," + std::to_string(panels) + " title " + gnuplot_quoted(title) + " noenhanced\n";
  if (!time.empty()) drawing += "set ylabel 'time error on the mesh of the scene [body size, rms]'\n" + time + "\n";
  if (!total.empty()) drawing += "set ylabel 'total error, against the finest mesh [body size, rms]'\n" + total + "\n";
  drawing += "unset multiplot\n";
  const auto picture = [&](const std::string& terminal, int width, int height, const std::string& extension) {
    return "set terminal " + terminal + " size " + std::to_string(width * panels) + "," + std::to_string(height) +
           "\nset output " + gnuplot_quoted(base.string() + extension) + "\n" + drawing;
  };
  return data + settings + picture("svg font 'sans,12' background 'white'", 560, 620, ".svg") +
         picture("pngcairo font 'sans,12'", 800, 860, ".png");
}

}  // namespace app
