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
      {.path = "title",
       .kind = Kind::text,
       .absent = "none",
       .meaning = "What the scene shows, in a few words; drawn above the picture.",
       .binding = field<whole_document, &Document::title>},
      {.path = "seed",
       .kind = Kind::integer,
       .range = at_least(0),
       .meaning = "Where the random numbers of the scene begin: another seed gives other random starts. The option "
                  "--seed sets it too.",
       .binding = field<scene_of, &sim::Scene::seed>},
      {.path = "time", .kind = Kind::table, .meaning = "How long the scene lasts and how it is stepped."},
      {.path = "time.seconds",
       .kind = Kind::number,
       .unit = "s",
       .range = {.low = 0, .high = 1e6, .low_open = true},
       .meaning = "How much time is simulated.",
       .binding = field<time_of, &sim::Time::seconds>},
      {.path = "time.fps",
       .kind = Kind::integer,
       .unit = "1/s",
       .range = between(1, 1e6),
       .meaning = "Frames per simulated second: frame k lies at k/fps exactly.",
       .binding = field<time_of, &sim::Time::fps>},
      {.path = "time.substeps",
       .kind = Kind::substeps,
       .range = between(1, 1e6),
       .meaning = "Steps per frame; a step is h = 1/(fps substeps) long. \"auto\" takes as many as an explicit "
                  "integrator needs to be stable.",
       .binding = field<time_of, &sim::Time::substeps>},
      {.path = "time.step",
       .kind = Kind::number,
       .unit = "s",
       .range = {.low = 1e-9, .high = 1e6},
       .absent = "from substeps",
       .meaning = "Instead of substeps: the longest step that is allowed. The longest step below it that divides a "
                  "frame is taken, and said.",
       .binding = {.get = [](const Document&, const Indices&) { return std::optional<Value>(); }, .set = set_step}},
      {.path = "time.integrator",
       .kind = Kind::choice,
       .choices = integrator_names,
       .meaning = "Time integration scheme.",
       .binding = field<time_of, &sim::Time::integrator>},
  };
}

}  // namespace app
