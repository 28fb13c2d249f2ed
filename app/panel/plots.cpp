#include "app/panel/plots.h"

#include "render/gui.h"

namespace app {
namespace {

struct Line {
  const char* name;
  double (*value)(const Sample&);
};

void draw(const char* title, const char* unit, const std::vector<Line>& lines, const std::vector<Sample>& samples,
          float text) {
  render::Strip strip;
  strip.title = title;
  strip.unit = unit;
  for (const Sample& sample : samples) strip.times.push_back(static_cast<float>(sample.t));
  for (const Line& line : lines) {
    render::Series& series = strip.series.emplace_back(render::Series{line.name, {}});
    for (const Sample& sample : samples) series.values.push_back(static_cast<float>(line.value(sample)));
  }
  render::plot_widget(strip, text);
}

}  // namespace

void draw_plots(const std::vector<Sample>& samples, bool clock, float text) {
  draw("energy", "J",
       {{"kinetic", [](const Sample& s) { return s.kinetic; }},
        {"elastic", [](const Sample& s) { return s.elastic; }},
        {"potential", [](const Sample& s) { return s.potential; }},
        {"total", [](const Sample& s) { return s.kinetic + s.elastic + s.potential; }}},
       samples, text);
  draw("iterations", "",
       {{"Newton", [](const Sample& s) { return double(s.newton); }},
        {"linear", [](const Sample& s) { return double(s.linear); }}},
       samples, text);
  draw("smallest J", "", {{"J", [](const Sample& s) { return s.min_J; }}}, samples, text);
  if (!clock) return;
  draw("time of a step", "ms",
       {{"assemble", [](const Sample& s) { return 1e3 * s.assembling; }},
        {"solve", [](const Sample& s) { return 1e3 * s.solving; }},
        {"rest", [](const Sample& s) { return 1e3 * s.other; }}},
       samples, text);
}

}  // namespace app
