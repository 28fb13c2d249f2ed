#include "app/panel/plots.h"

#include <imgui.h>

#include "render/page.h"
#include "render/strip.h"

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
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high = {low.x + ImGui::GetContentRegionAvail().x, low.y + 6.5F * text};
  render::Page page;
  page.list = ImGui::GetWindowDrawList();
  page.text = page.bold = ImGui::GetFont();
  page.size = text;
  draw_strip(page, strip, low, high);
  ImGui::Dummy({high.x - low.x, high.y - low.y + 0.3F * text});
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
