#include "app/trade/plot.h"

#include <cmath>

#include "app/base/gnuplot.h"
#include "app/base/number_text.h"
#include "app/base/text.h"
#include "app/trade/chart_layout.h"

namespace app {
namespace {

std::string data_block(const std::string& name, const std::vector<Dot>& dots) {
  std::string text = name + " << EOD\n";
  for (const Dot& dot : dots) {
    append_number(text, dot.seconds);
    text += ' ';
    append_number(text, dot.error);
    text += " # " + dot.of + (dot.below ? ", below" : "") + '\n';
  }
  return text + "EOD\n";
}

std::string style(const Line& line) {
  return formatted("%s pt %d ps %.1f lw 3 dt %d lc rgb '%s'", line.joined ? "linespoints" : "points", line.ink.point,
                   1.6 * line.size, line.ink.dashes, line.ink.colour.c_str());
}

std::string font(double height) {
  return formatted("font ',%.0f'", height);
}

std::string range(const char* axis, const AxisRange& range) {
  return formatted("set %srange [%.6g:%.6g]\n", axis, range.low, range.high);
}

// Numbers at 1 of every decade, at more where there are few decades.
std::string tics(const char* axis, const AxisRange& range) {
  const double decades = std::log10(range.high / range.low);
  const std::vector<double> digits = decades > 2.2   ? std::vector<double>{1}
                                     : decades > 0.9 ? std::vector<double>{1, 2, 5}
                                                     : std::vector<double>{1, 2, 3, 4, 5, 6, 8};
  std::string text = std::string("set ") + axis + "tics nomirror (";
  bool first = true;
  for (double decade = std::pow(10, std::floor(std::log10(range.low))); decade <= range.high; decade *= 10)
    for (const double digit : digits) {
      if (!range.holds(digit * decade)) continue;
      text += formatted("%s'%g' %g", first ? "" : ", ", digit * decade, digit * decade);
      first = false;
    }
  return text + ")\n";
}

std::string axes(const Chart& chart) {
  std::string text = "set logscale xy\nset border lw 2\n" + range("x", chart.seconds) + range("y", chart.error);
  text += formatted(
      "set lmargin at screen %.4f\nset rmargin at screen %.4f\nset bmargin at screen %.4f\nset tmargin at "
      "screen %.4f\n",
      axes_left / chart_width, axes_right / chart_width, axes_below / chart_height, axes_above / chart_height);
  text += "set ylabel '% of the size' offset 0.5,0\n";
  text += tics("x", chart.seconds) + tics("y", chart.error) + "set grid lc rgb '#cccccc' lw 1 dt 1\n";
  if (chart.pixels > 0) {
    const AxisRange pixels{chart.pixels * chart.error.low, chart.pixels * chart.error.high};
    text += "set logscale y2\n" + tics("y2", pixels) + "set y2label 'pixels at 1080p' offset -2.2,0\n" +
            range("y2", pixels);
  }
  return text + "set key at screen 0.998,0.87 right top Left reverse noenhanced samplen 1.2 spacing 1.1 " +
         font(small_letters) + "\n";
}

// What lies behind the lines: where nothing can be told, real time, the budget, the target.
std::string behind(const Chart& chart) {
  std::string text;
  if (chart.floor > 0)
    text += formatted(
        "set object 1 rectangle from graph 0, graph 0 to graph 1, first %.6g fc rgb '#d8d8d8' fs solid "
        "noborder behind\n",
        chart.floor);
  const auto vertical = [&](double seconds, const char* colour) {
    text += formatted("set arrow from first %.6g, graph 0 to first %.6g, graph 1 nohead lw 4 dt 1 lc rgb '%s' back\n",
                      seconds, seconds, colour);
  };
  vertical(1, black);
  if (chart.budget > 0) vertical(chart.budget, blue);
  if (chart.target > 0)
    text += formatted("set arrow from graph 0, first %.6g to graph 1, first %.6g nohead lw 4 dt 1 lc rgb '%s' back\n",
                      chart.target, chart.target, blue);
  return text;
}

std::string written(const PlacedText& text) {
  return "set label " + gnuplot_quoted(text.text) +
         formatted(" at screen %.4f, screen %.4f left noenhanced front tc rgb '%s' ", text.x / chart_width,
                   text.y / chart_height, text.colour.c_str()) +
         font(text.large ? large_letters : small_letters) + "\n";
}

std::string failures(const Chart& chart) {
  constexpr std::size_t most = 2, letters = 100;
  std::string text;
  for (const Failure& failure : chart.failures)
    text += formatted("set label '' at first %.6g, graph 0.97 point pt 2 ps 2 lw 4 lc rgb '%s' front\n",
                      failure.seconds, red);
  for (std::size_t k = 0; k < chart.failures.size() && k < most; ++k) {
    std::string cause = "x " + chart.failures[k].text.substr(0, letters);
    if (k + 1 == most && chart.failures.size() > most)
      cause = formatted("x %zu settings failed, listed in the table", chart.failures.size() - 1);
    text += written({20, 42 - 26 * double(k), cause, false, red});
  }
  return text;
}

std::string triangle(const SlopeTriangle& t) {
  const auto side = [](double x0, double y0, double x1, double y1) {
    return formatted("set arrow from first %.6g, first %.6g to first %.6g, first %.6g nohead lw 2 lc rgb '%s' front\n",
                     x0, y0, x1, y1, black);
  };
  const double right = t.seconds * t.wide, top = t.error * t.high;
  return side(t.seconds, t.error, right, t.error) + side(t.seconds, t.error, t.seconds, top) +
         side(t.seconds, top, right, t.error);
}

}  // namespace

std::string plot_script(const Chart& chart, const std::filesystem::path& base) {
  std::string data, plot;
  if (!chart.front.empty()) {
    data += data_block("$front", chart.front);
    plot += "plot $front using 1:2 with lines lw 14 lc rgb '#ffd880' title 'front'";
  }
  int block = 0;
  for (const Line& line : chart.lines) {
    const std::string name = "$line" + std::to_string(++block);
    data += data_block(name, line.dots);
    plot += (plot.empty() ? "plot " : ", \\\n  ") + name + " using 1:2 with " + style(line) +
            (line.title.empty() ? " notitle" : " title " + gnuplot_quoted(line.title));
  }
  if (plot.empty()) return "# nothing was measured that could be drawn\n";
  const ChartLayout layout = lay_out(chart);
  std::string drawing = axes(chart) + behind(chart) + failures(chart);
  drawing += written({axes_left, axes_above + 60, chart.title, true, black});
  drawing += written({axes_left, axes_above + 22, chart.error_name, false, black});
  drawing += written({axes_left + 60, 84, "seconds of computing for a simulated second", true, black});
  for (const PlacedText& text : layout.texts) drawing += written(text);
  for (const SlopeTriangle& t : layout.triangles) drawing += triangle(t);
  drawing += plot + "\n";
  // Letters are given in pixels: those of SVG are, those of the other are points of 4/3 of a pixel.
  const auto picture = [&](const std::string& terminal, const std::string& extension) {
    return "reset\nset terminal " + terminal +
           formatted(" font 'sans,%.0f' size %.0f,%.0f\nset output ", large_letters, chart_width, chart_height) +
           gnuplot_quoted(base.string() + extension) + "\n" + drawing + "unset output\n";
  };
  return data + picture("svg background 'white'", ".svg") + picture("pngcairo fontscale 0.75", ".png");
}

}  // namespace app
