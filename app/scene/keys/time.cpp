// Keys of the file's head and of [time].
#include <cmath>

#include "app/base/number_text.h"
#include "app/scene/keys/binding.h"
#include "app/scene/keys/choices.h"

namespace app {
namespace {

constexpr auto time_of = [](auto& d, const Indices&) -> auto& {
  return d.scene.time;
};

// h = 1/(fps n) with the least n for which h <= step [s]; a step that divides the frame but for round-off is taken
// as it is.
void set_step(Document& document, const Indices&, const Value& value) {
  sim::Time& time = document.scene.time;
  const double step = std::get<double>(value);
  const double steps = std::ceil(1 / (time.fps * step) * (1 - 1e-12));
  time.substeps = static_cast<int>(std::clamp(steps, 1.0, 1e6));
  std::string remark = "time.step = ";
  append_number(remark, step);
  remark += " s: " + std::to_string(time.substeps) + (time.substeps == 1 ? " step" : " steps") + " per frame, h = ";
  append_number(remark, 1.0 / (double(time.fps) * time.substeps));
  document.remarks.push_back(remark + " s");
}

}  // namespace

std::vector<Key> time_keys() {
  return {
      {"title", Form(Kind::text).tells(Effect::look).otherwise("none"), field<whole_document, &Document::title>,
       "What the scene shows, in a few words; drawn above the picture."},
      {"seed", Form(Kind::integer, "", at_least(0)).tells(Effect::start), field<scene_of, &sim::Scene::seed>,
       "Where the random numbers of the scene begin: another seed gives other random starts. The option --seed sets it "
       "too."},
      {"time", Kind::table, {}, "How long the scene lasts and how it is stepped."},
      {"time.seconds", Form(Kind::number, "s", Range{.low = 0, .high = 1e6, .low_open = true}).tells(Effect::look),
       field<time_of, &sim::Time::seconds>, "How much time is simulated."},
      {"time.fps", Form(Kind::integer, "1/s", between(1, 1e6)).tells(Effect::restart), field<time_of, &sim::Time::fps>,
       "Frames per simulated second: frame k lies at k/fps exactly."},
      {"time.substeps", Form(Kind::substeps, "", between(1, 1e6)), field<time_of, &sim::Time::substeps>,
       "Steps per frame; a step is h = 1/(fps substeps) long. \"auto\" takes as many as an explicit integrator needs "
       "to be stable, which is what they take where nothing is said."},
      {"time.step",
       Form(Kind::number, "s", between(1e-9, 1e6)).otherwise("from substeps"),
       {.get = [](const Document&, const Indices&) { return std::optional<Value>(); }, .set = set_step},
       "Instead of substeps: the longest step that is allowed. The longest step below it that divides a frame is "
       "taken, and said."},
      {"time.integrator", Form(Kind::choice).of(integrator_names), field<time_of, &sim::Time::integrator>,
       "Time integration scheme."},
  };
}

}  // namespace app
