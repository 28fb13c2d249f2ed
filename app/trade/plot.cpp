#include "app/trade/plot.h"

#include <cmath>

#include "app/base/gnuplot.h"
#include "app/base/number_text.h"
#include "app/base/text.h"
#include "app/trade/chart_layout.h"

namespace app {
namespace {

constexpr const char* front_style = "lw 14 lc rgb '#ffd880'";

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

// The layers of a mark from below, as gnuplot says them: of closed ones the inside, the edge, the white middle of
// hollow ones; of crosses with an edge a broad one below a narrow one.
std::vector<std::string> mark_layers(const Ink& ink, double size) {
  constexpr double points = 2.8, edge = 3;  // of gnuplot
  const auto layer = [&](int mark, double part, double width, const char* colour) {
    return formatted("pt %d ps %.2f lw %.1f lc rgb '%s'", mark, part * points * size, width, colour);
  };
  if (std::string_view(ink.dark) == ink.bright) return {layer(ink.mark, 0.6, edge, ink.dark)};
  if (ink.mark <= 3) return {layer(ink.mark, 1, 3 * edge, ink.dark), layer(ink.mark, 0.9, edge, ink.bright)};
  // Open marks have the number before that of closed ones.
  std::vector<std::string> layers = {layer(ink.mark, 1, 1, ink.bright), layer(ink.mark - 1, 1, edge, ink.dark)};
  if (ink.hollow) layers.push_back(layer(ink.mark, 0.35, 1, "#ffffff"));
  return layers;
}

// A dark line, and on it a bright one with the dashes.
std::vector<std::string> line_layers(const Ink& ink) {
  return {formatted("lw 6 dt 1 lc rgb '%s'", ink.dark), formatted("lw 3 dt %d lc rgb '%s'", ink.dashes, ink.bright)};
}

std::string font(double height) {
  return formatted("font ',%.0f'", height);
}

std::string range(const char* axis, const AxisRange& range) {
  return formatted("set %srange [%.6g:%.6g]\n", axis, range.low, range.high);
}

// "0.05", "1e-4": long ones do not fit beside the axes.
std::string tic_text(double value) {
  if (value > 0.0099 && value < 9999) return formatted("%g", value);
  const double exponent = std::floor(std::log10(value) + 1e-9);
  return formatted("%ge%.0f", value / std::pow(10, exponent), exponent);
}

// Numbers at 1 of every decade, at more where there are few decades.
std::string tics(const char* axis, const AxisRange& range) {
  const double decades = std::log10(range.high / range.low);
  const std::vector<double> digits = decades > 2.2   ? std::vector<double>{1}
                                     : decades > 0.9 ? std::vector<double>{1, 2, 5}
                                     : decades > 0.4
                                         ? std::vector<double>{1, 2, 3, 4, 5, 6, 8}
                                         : std::vector<double>{1, 1.2, 1.5, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 8, 9};
  std::string text = std::string("set ") + axis + "tics nomirror (";
  bool first = true;
  for (double decade = std::pow(10, std::floor(std::log10(range.low))); decade <= range.high; decade *= 10)
    for (const double digit : digits) {
      if (!range.holds(digit * decade)) continue;
      text += formatted("%s'%s' %g", first ? "" : ", ", tic_text(digit * decade).c_str(), digit * decade);
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
  text += tics("x", chart.seconds) + tics("y", chart.error) + "set grid lc rgb '#cccccc' lw 1 dt 1\nunset key\n";
  if (chart.pixels > 0) {
    const AxisRange pixels{chart.pixels * chart.error.low, chart.pixels * chart.error.high};
    text += "set logscale y2\n" + tics("y2", pixels) + range("y2", pixels);
  }
  return text;
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

// Names of the axes above their ends, so that they stand upright and clear of the numbers.
std::string headings(const Chart& chart) {
  constexpr double title = 152, names = 27, end_of_pixels = axes_right + 95;  // pixels above the axes; from the left
  const std::string seconds = "seconds of computing for a simulated second", pixels = "pixels at 1080p";
  std::string text =
      written({axes_left, axes_above + title, fitting(chart.title, true, chart_width - axes_left - 10), true, black}) +
      written({axes_left - 60, axes_above + names, "% of the size: " + chart.error_name, false, black}) +
      written({(axes_left + axes_right - text_width(seconds, false)) / 2, axes_below - 62, seconds, false, black});
  if (chart.pixels > 0)
    text += written({end_of_pixels - text_width(pixels, false), axes_above + names, pixels, false, black});
  return text;
}

// The names of the lines, each beside its line and mark, in rows between the title and the axes.
std::string legend(const Chart& chart) {
  constexpr double line_width = 48, before_text = 10, between = 26, spacing = 30, first_row = 116;  // pixels
  double x = axes_left, y = axes_above + first_row;
  std::string text;
  const auto line = [&](const std::string& style) {
    return formatted("set arrow from screen %.4f, screen %.4f to screen %.4f, screen %.4f nohead front %s\n",
                     x / chart_width, y / chart_height, (x + line_width) / chart_width, y / chart_height,
                     style.c_str());
  };
  const auto place = [&](const std::string& name) {
    const double width = line_width + before_text + text_width(name, false);
    if (x > axes_left && x + width > chart_width) {
      x = axes_left;
      y -= spacing;
    }
  };
  const auto write = [&](const std::string& name, const std::string& drawn) {
    text += drawn + written({x + line_width + before_text, y, name, false, black});
    x += line_width + before_text + text_width(name, false) + between;
  };
  if (!chart.front.empty()) write("front", line(front_style));
  for (const Line& one : chart.lines) {
    if (one.title.empty()) continue;
    place(one.title);
    std::string drawn;
    if (one.joined)
      for (const std::string& style : line_layers(one.ink)) drawn += line(style);
    for (const std::string& style : mark_layers(one.ink, one.size))
      drawn += formatted("set label '' at screen %.4f, screen %.4f point %s front\n",
                         (x + line_width / 2) / chart_width, y / chart_height, style.c_str());
    write(one.title, drawn);
  }
  return text;
}

// What is advised; what failed: marked at the upper margin, the cause below the picture.
std::string footing(const Chart& chart) {
  constexpr std::size_t most = 2;
  constexpr double left = 20, spacing = 26, first = 66;  // pixels
  std::string text;
  if (!chart.advice.empty())
    text += written({left, first, fitting("advice: " + chart.advice, false, chart_width - 2 * left), false, red});
  for (const Failure& failure : chart.failures)
    text += formatted("set label '' at first %.6g, graph 0.97 point pt 2 ps 2 lw 4 lc rgb '%s' front\n",
                      failure.seconds, red);
  for (std::size_t k = 0; k < chart.failures.size() && k < most; ++k) {
    std::string cause = "x " + chart.failures[k].text;
    if (k + 1 == most && chart.failures.size() > most)
      cause = formatted("x %zu settings failed, listed in the table", chart.failures.size() - 1);
    text += written({left, first - spacing * double(k + 1), fitting(cause, false, chart_width - 2 * left), false, red});
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

std::string lead(const Leader& l) {
  return formatted(
      "set arrow from screen %.4f, screen %.4f to screen %.4f, screen %.4f nohead lw 2 lc rgb '%s' front\n",
      l.x0 / chart_width, l.y0 / chart_height, l.x1 / chart_width, l.y1 / chart_height, l.colour.c_str());
}

}  // namespace

std::string plot_script(const Chart& chart, const std::filesystem::path& base) {
  std::string data;
  std::vector<std::string> lines, marks;  // marks lie on all lines
  if (!chart.front.empty()) {
    data += data_block("$front", chart.front);
    lines.push_back(std::string("$front using 1:2 with lines ") + front_style);
  }
  int block = 0;
  for (const Line& line : chart.lines) {
    const std::string name = "$line" + std::to_string(++block);
    data += data_block(name, line.dots);
    if (line.joined)
      for (const std::string& style : line_layers(line.ink)) lines.push_back(name + " using 1:2 with lines " + style);
    for (const std::string& style : mark_layers(line.ink, line.size))
      marks.push_back(name + " using 1:2 with points " + style);
  }
  lines.insert(lines.end(), marks.begin(), marks.end());
  if (lines.empty()) return "# nothing was measured that could be drawn\n";
  std::string drawing = axes(chart) + behind(chart) + footing(chart) + headings(chart) + legend(chart);
  const ChartLayout layout = lay_out(chart);
  for (const PlacedText& text : layout.texts) drawing += written(text);
  for (const Leader& leader : layout.leaders) drawing += lead(leader);
  for (const SlopeTriangle& t : layout.triangles) drawing += triangle(t);
  for (const std::string& part : lines) drawing += (&part == &lines.front() ? "plot " : ", \\\n  ") + part;
  drawing += "\n";
  // Letters are given in pixels: those of SVG are, those of the other are points of 4/3 of a pixel.
  const auto picture = [&](const std::string& terminal, const std::string& extension) {
    return "reset\nset terminal " + terminal +
           formatted(" font 'sans,%.0f' size %.0f,%.0f\nset output ", large_letters, chart_width, chart_height) +
           gnuplot_quoted(base.string() + extension) + "\n" + drawing + "unset output\n";
  };
  return data + picture("svg background 'white'", ".svg") + picture("pngcairo fontscale 0.75", ".png");
}

}  // namespace app
