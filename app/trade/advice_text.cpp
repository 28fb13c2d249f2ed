#include "app/trade/advice_text.h"

#include <algorithm>

#include "app/base/json.h"
#include "app/base/text.h"
#include "app/base/version.h"
#include "app/scene/scene_file.h"
#include "app/trade/advice.h"
#include "app/trade/table.h"

namespace app {
namespace {

const std::optional<Apart>& whole_error(const Score& score) {
  return score.total ? score.total : score.time ? score.time : score.model;
}

std::string seconds_text(double seconds) {
  return formatted("%.3g s", seconds);
}

void add_apart(Json& json, std::string_view name, const std::optional<Apart>& apart) {
  if (!apart) return;
  json.key(name).open_object().member("rms", apart->rms).member("max", apart->max).member("pixels", apart->pixels);
  json.close_object();
}

void add_score(Json& json, const Score& score) {
  const CaseRun& run = *score.run;
  json.open_object().member("case", run.which.label).key("settings").open_object();
  for (const auto& [key, value] : run.which.settings) json.member(key, value);
  json.close_object();
  add_apart(json, "time_error", score.time);
  add_apart(json, "mesh_error", score.mesh);
  add_apart(json, "model_error", score.model);
  add_apart(json, "total_error", score.total);
  json.member("error_bound", score.bound.rms).member("seconds_per_second", score.seconds);
  json.member("least_wall_seconds_per_second", run.work.least()).member("cpu_seconds_per_second", run.work.cpu);
  if (run.training > 0) json.member("training_seconds", run.training);
  json.close_object();
}

void add_references(Json& json, const References& references) {
  const sim::ReferenceCheck& check = references.check;
  json.key("reference").open_object();
  if (references.time) json.member("case", references.time->which.label);
  json.member("moved_by_halving", check.moved).member("second_scheme_apart", check.apart);
  json.member("uncertainty", check.uncertainty).member("agrees", check.agrees);
  json.member("horizon", check.horizon).member("chaotic", check.diverges);
  if (references.mesh) json.member("finest_mesh", references.mesh->which.label);
  json.member("total_uncertainty", references.total_uncertainty.rms).close_object();
}

}  // namespace

std::string error_text(const Apart& apart) {
  return percent(apart.rms) + " (" + formatted("%.2g", apart.pixels) + " px)";
}

std::string bounded_text(const Score& score) {
  if (!whole_error(score)) return "no error known";
  const Apart& error = *whole_error(score);
  if (score.bound.rms > told_apart * error.rms) return "below " + error_text(score.bound);
  return error_text(error) + ", at most " + percent(score.bound.rms);
}

namespace {

// What has to be made before the first step of a body that moves in a basis, and from what.
std::string training_text(const Measurement& m, const Score& score) {
  const CaseRun& run = *score.run;
  if (!(run.training > 0)) return {};
  const Options options = options_of(m.comparison.options, run.which);
  const Document scene = load_scene(options.scene, options.settings, options.overrides);
  std::string trained_on;
  for (std::size_t b = 0; b < scene.scene.bodies.size(); ++b) {
    const sim::Basis& basis = *scene.scene.bodies[b].basis;
    if (basis.cubature == 0) continue;
    trained_on += (trained_on.empty() ? "; trained on " : " and ") +
                  (basis.snapshots ? "the states of " + scene.basis_folders[b].string()
                                   : "what \"" + scene.scene.bodies[b].name + "\" does in it, swinging under loads");
  }
  return "  the basis takes " + seconds_text(run.training) + " to make, once: the first simulated second costs " +
         seconds_text(run.training + score.seconds) + trained_on + "\n";
}

}  // namespace

std::string advice_text(const Measurement& m, const Advice& advice, const std::filesystem::path& settings) {
  if (!advice.chosen) return "No advice: no error is known.\n";
  const Score& chosen = *advice.chosen;
  std::string text;
  if (!meets(chosen, m.goal))
    text += "note: nothing that was measured is within " + m.goal.text + "; this comes nearest\n";
  const sim::ReferenceCheck& check = m.scorer.references().check;
  if (check.diverges)
    text += "note: this holds for the first " + seconds_text(std::min(check.horizon, m.comparison.seconds())) +
            ": from then on the motion is chaotic, and no run tells where the bodies are\n";
  else if (m.comparison.shortened())
    text += "note: this holds for the first " + seconds_text(m.comparison.seconds()) +
            ", not for the whole scene: errors grow with time\n";
  if (!chosen.total) text += "note: the error is that of time alone: no mesh error is known\n";
  if (advice.own && whole_error(*advice.own))
    text += "The scene as it is: " + bounded_text(*advice.own) + ", " + seconds_text(advice.own->seconds) +
            " per simulated second\n";
  text += "Advice for " + m.goal.text + ": " + chosen.run->which.label + "\n";
  text += "  predicted " + bounded_text(chosen) + ", " + seconds_text(chosen.seconds) +
          " per simulated second; found " + bounded_text(advice.found) + ", " + seconds_text(advice.found.seconds) +
          " (on this machine now: wall " + seconds_text(advice.fresh->work.least()) + ", CPU " +
          seconds_text(advice.fresh->work.cpu) + ")\n";
  text += training_text(m, chosen);
  text += "  ritz record " + m.comparison.options.scene.string() + " --settings " + settings.string();
  for (const auto& [key, value] : chosen.run->which.settings)
    if (key == thread_option) text += " " + key + " " + value;
  return text + "\n";
}

std::string trade_json(Measurement& m, const Plan& plan, const Advice& advice) {
  const std::vector<const Score*> scores = m.scores();
  Json json;
  json.open_object().member("scene", m.comparison.options.scene.string());
  json.member("version", ritz_version).member("goal", m.goal.text);
  json.member("compared_seconds", m.comparison.seconds()).member("depth", plan.depth);
  add_references(json, m.scorer.references());
  json.key("notes").open_array();
  for (const std::string& note : m.notes) json.value(note);
  json.close_array().key("seconds_spent").open_object();
  for (const auto& [phase, seconds] : m.spent) json.member(phase, seconds);
  json.close_object().key("orders").open_object();
  for (const Slope& slope : slopes(scores)) json.member(slope.integrator, slope.slope);
  json.close_object();
  if (advice.chosen) {
    add_score(json.key("advice"), *advice.chosen);
    add_score(json.key("found"), advice.found);
  }
  json.key("cases").open_array();
  for (const Score* score : scores) add_score(json, *score);
  json.close_array().close_object();
  return json.text();
}

}  // namespace app
