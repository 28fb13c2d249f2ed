#include "app/run/run_json.h"

#include <sys/resource.h>

#include "app/base/json.h"
#include "app/base/text.h"
#include "app/base/version.h"
#include "app/scene/scene_text.h"

namespace app {
namespace {

const char* text(Status status) {
  switch (status) {
    case Status::running:
      return "running";
    case Status::done:
      return "done";
    case Status::interrupted:
      return "interrupted";
    case Status::failed:
      return "failed";
  }
  return "";
}

// Largest memory of this process so far; the system counts in units of 1024 bytes.
std::int64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::int64_t{usage.ru_maxrss} * 1024;
}

void put_options(Json& json, const Options& options) {
  json.key("options").open_object();
  json.member("command", options.command).member("scene", options.scene.string());
  json.member("settings", options.settings.string());
  json.key("set").open_array();
  for (const Override& override : options.overrides) json.value(override.key + "=" + override.value);
  json.close_array();
  json.member("threads", options.threads).member("seed", options.seed);
  json.member("width", options.width).member("height", options.height);
  json.member("samples", options.samples).member("expect", options.expect.string());
  json.member("every", options.every).member("still", options.still);
  json.member("video", options.video.string()).member("vtu", options.vtu);
  json.member("panel", options.panel).member("replay", options.replay.string());
  json.close_object();
}

void put_status(Json& json, const Simulation& simulation, const Outcome& outcome) {
  json.member("status", text(outcome.status));
  if (!outcome.error.empty()) json.member("reason", outcome.error);
  if (outcome.failure.failure.empty()) return;
  const std::int64_t step = outcome.run.state.step + 1;
  json.member("reason", outcome.failure.failure);
  json.key("failed_at").open_object();
  json.member("step", step).member("t", simulation.system->time(step));
  json.member("element", outcome.failure.min_J_element).member("min_J", outcome.failure.min_J);
  json.close_object();
}

void put_system(Json& json, const sim::System& system) {
  json.key("terms").open_array();
  for (const sim::TermInfo& term : system.terms()) {
    json.open_object().member("name", term.name).member("what", term.what).close_object();
  }
  json.close_array();
  const sim::Counts counts = system.counts();
  json.key("counts").open_object();
  json.member("nodes", counts.nodes).member("elements", counts.elements);
  json.member("dofs", counts.dofs).member("free_dofs", counts.free_dofs).member("nonzeros", counts.nonzeros);
  json.close_object();
}

void put_remarks(Json& json, const Simulation& simulation) {
  json.key("remarks").open_array();
  for (const std::string& remark : simulation.remarks()) json.value(remark);
  json.close_array();
}

void put_work(Json& json, const Simulation& simulation, const Outcome& outcome) {
  const sim::System& system = *simulation.system;
  const std::int64_t step = outcome.run.state.step;
  json.member("step_seconds", system.step_seconds()).member("steps_per_frame", system.steps_per_frame());
  json.member("last_frame", step / system.steps_per_frame());
  if (outcome.resumed_step >= 0) json.member("resumed_from_step", outcome.resumed_step);
  const Totals& totals = outcome.run.totals;
  json.member("steps", step).member("t", system.time(step));
  json.member("newton_iterations", totals.newton).member("linear_iterations", totals.linear);
  json.member("steps_not_converged", totals.not_converged);
  if (!outcome.not_converged_reason.empty()) json.member("not_converged_reason", outcome.not_converged_reason);
  json.member("steps_halved", totals.splits).member("min_J", totals.min_J);
  json.member("inverted_elements", outcome.inverted).member("no_memory_for_factor", outcome.no_factor);
}

void put_drawn_by(Json& json, const DrawnBy& drawn_by) {
  if (drawn_by.context.empty()) return;
  json.key("drawn_by").open_object();
  json.member("context", drawn_by.context).member("driver", drawn_by.driver);
  json.close_object();
}

// Of this process: a run that was resumed does not know the seconds before.
void put_seconds(Json& json, const Simulation& simulation, const Outcome& outcome, const FrameSeconds& frames) {
  json.key("seconds").open_object();
  json.member("building", simulation.build_seconds).member("stepping", outcome.stepping);
  json.member("assembling", outcome.assembling).member("solving", outcome.solving);
  json.member("drawing", frames.drawing).member("writing", frames.writing);
  json.member("waiting", frames.waiting).member("total", outcome.total);
  json.close_object();
}

}  // namespace

std::string run_json(const Simulation& simulation, const Options& options, const RunFolder& folder,
                     const Outcome& outcome, const FrameSink& frames) {
  Json json;
  json.open_object();
  json.member("program", "ritz").member("version", ritz_version);
  put_status(json, simulation, outcome);
  put_options(json, options);
  json.key("scene").raw(scene_json(simulation.document, folder.path()));
  put_system(json, *simulation.system);
  put_remarks(json, simulation);
  put_work(json, simulation, outcome);
  put_drawn_by(json, frames.drawn_by());
  put_seconds(json, simulation, outcome, frames.seconds());
  json.member("peak_memory_bytes", peak_memory_bytes());
  json.member("state_hash", hexadecimal(sim::hash(outcome.run.state)));
  json.close_object();
  return json.text();
}

}  // namespace app
