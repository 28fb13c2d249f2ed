#include "app/trade/trade.h"

#include <fstream>
#include <iostream>

#include "app/base/gnuplot.h"
#include "app/base/json.h"
#include "app/base/output_file.h"
#include "app/base/text.h"
#include "app/base/version.h"
#include "app/trade/advice.h"
#include "app/trade/table.h"

namespace app {
namespace {

// "0.62 % (2.1 px)"
std::string error_text(const Apart& apart) {
  return percent(apart.rms) + " of the size (" + formatted("%.2g", apart.pixels) + " px)";
}

const std::optional<Apart>& whole_error(const Score& score) {
  return score.total ? score.total : score.time ? score.time : score.model;
}

// The identity of the scene that a folder holds a trade of; empty when it holds none.
std::string held_scene(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

// A folder is for one scene: what lies there of another is left alone.
void take_folder(const std::filesystem::path& folder, std::uint64_t identity, bool overwrite) {
  const std::filesystem::path file = folder / "cases" / "scene";
  const std::string mine = std::string(ritz_version) + " " + std::to_string(identity), held = held_scene(file);
  if (overwrite) std::filesystem::remove_all(folder / "cases");
  if (!overwrite && !held.empty() && held != mine)
    throw std::runtime_error(folder.string() +
                             ": holds the trade of another scene, or of other settings; choose another folder with "
                             "-o, or replace it with --overwrite");
  make_folder(folder / "cases");
  std::error_code error;
  if (overwrite) std::filesystem::remove(folder / "plan.toml", error);
  if (held != mine || overwrite) write_atomically(file, mine + "\n", false);
}

std::filesystem::path cases_folder(const Options& options, const std::filesystem::path& folder,
                                   std::uint64_t identity) {
  take_folder(folder, identity, options.overwrite);
  return folder / "cases";
}

void add_apart(Json& json, std::string_view name, const std::optional<Apart>& apart) {
  if (!apart) return;
  json.key(name).open_object().member("rms", apart->rms).member("max", apart->max).member("pixels", apart->pixels);
  json.close_object();
}

void add_score(Json& json, const Score& score) {
  const CaseRun& run = *score.run;
  json.member("case", run.which.label).key("settings").open_object();
  for (const auto& [key, value] : run.which.settings) json.member(key, value);
  json.close_object();
  add_apart(json, "time_error", score.time);
  add_apart(json, "mesh_error", score.mesh);
  add_apart(json, "model_error", score.model);
  add_apart(json, "total_error", score.total);
  json.member("error_bound", score.bound.rms).member("seconds_per_second", run.work.median());
  json.member("least_seconds_per_second", run.work.least());
}

}  // namespace

std::filesystem::path trade_folder(const Options& options) {
  return options.out.empty() ? std::filesystem::path("out") / "trade" / options.scene.stem() : options.out;
}

double trade_seconds(const TradeOptions& options) {
  constexpr double quick = 50;  // with the verification under a minute
  return options.quick ? quick : 60 * options.minutes;
}

Trade::Trade(const Options& options, std::filesystem::path folder, double seconds, const Interrupt& interrupt)
    : options_(options),
      folder_(std::move(folder)),
      comparison_(make_comparison(options)),
      goal_(read_goal(options.trade, comparison_.scene.document.scene.time)),
      notebook_(comparison_, cases_folder(options, folder_, comparison_.scene.identity), seconds,
                options.quiet ? nullptr : &std::cerr, interrupt),
      scorer_(comparison_),
      search_(comparison_, notebook_, scorer_, goal_, folder_) {
  notebook_.on_change([this] { write_csv(); });
}

bool Trade::measure(const std::optional<Plan>& plan) {
  try {
    search_.go(plan);
  } catch (const Interrupted&) {
    write_csv();
    return false;
  }
  return true;
}

void Trade::collect(const Plan& plan) {
  notebook_.recall_only("its job has not been run");
  search_.go(plan);
}

void Trade::write_csv() {
  write_atomically(folder_ / "trade.csv", trade_csv(search_.scores(), comparison_), false);
}

Diagram Trade::diagram() {
  const Document& document = comparison_.scene.document;
  return {document.title.empty() ? options_.scene.stem().string() : document.title, search_.scores(),
          scorer_.references().check.uncertainty, scorer_.references().total_uncertainty.rms,
          choose(search_.scores(), goal_)};
}

void draw(const std::vector<Diagram>& diagrams, const std::filesystem::path& base, bool quiet) {
  const std::filesystem::path script = base.string() + ".gp";
  write_atomically(script, plot_script(diagrams, base), false);
  if (!run_gnuplot(script))
    std::cerr << "note: no gnuplot here (apt-get install gnuplot-nox); where there is one, gnuplot " << script.string()
              << " draws the diagram\n";
  else if (!quiet)
    std::cerr << "diagram: " << base.string() << ".svg, .png\n";
}

void Trade::advise(Advice& advice) {
  advice.chosen = choose(search_.scores(), goal_);
  if (!advice.chosen) return;
  advice.fresh = notebook_.run_afresh(advice.chosen->run->which);
  advice.found = scorer_.judge(advice.fresh);
  const std::string comment =
      "ritz trade " + options_.scene.string() + ": for " + goal_.text + ": " + advice.chosen->run->which.label;
  write_atomically(folder_ / "advice.toml", advice_toml(advice.chosen->run->which, comment), false);
}

std::string Trade::advice_text(const Advice& advice) {
  if (!advice.chosen) return "No advice: no error is known.\n";
  const Score& chosen = *advice.chosen;
  const Score& own = scorer_.score(notebook_.run(scene_case(), 0));
  std::string text = "Advice for " + goal_.text + ": " + chosen.run->which.label + ". ";
  if (!meets(chosen, goal_)) text += "Nothing that was measured is within it; this comes nearest. ";
  text += "Predicted: an error of " + error_text(*whole_error(chosen)) + ", at most " + percent(chosen.bound.rms) +
          " with the uncertainty of the reference" + (chosen.total ? " and of the finest mesh" : "") + ", and " +
          formatted("%.3g", chosen.run->work.median()) + " s per simulated second. A fresh run found " +
          error_text(*whole_error(advice.found)) + " and " + formatted("%.3g", advice.fresh.work.median()) + " s. ";
  if (whole_error(own))
    text += "The scene as it is: " + error_text(*whole_error(own)) + ", " + formatted("%.3g", own.run->work.median()) +
            " s. ";
  if (comparison_.shortened())
    text += "All this holds for the first " + formatted("%.3g", comparison_.seconds()) +
            " s, not for the whole scene: errors grow with time. ";
  if (!chosen.total) text += "The error is that of time alone: no mesh error is known. ";
  return text + "To apply it: ritz record " + options_.scene.string() + " --settings " +
         (folder_ / "advice.toml").string() + "\n";
}

void Trade::write_json(const Advice& advice) {
  const References& references = scorer_.references();
  Json json;
  json.open_object()
      .member("scene", options_.scene.string())
      .member("version", ritz_version)
      .member("goal", goal_.text);
  json.member("compared_seconds", comparison_.seconds()).member("depth", search_.plan().depth);
  json.key("reference").open_object();
  json.member("moved_by_halving", references.check.moved).member("second_scheme_apart", references.check.apart);
  json.member("uncertainty", references.check.uncertainty).member("agrees", references.check.agrees);
  json.member("horizon", references.check.horizon).member("chaotic", references.check.diverges);
  if (references.mesh) json.member("finest_mesh", references.mesh->which.label);
  json.close_object().key("notes").open_array();
  for (const std::string& note : search_.notes()) json.value(note);
  json.close_array().key("orders").open_object();
  for (const Slope& slope : slopes(search_.scores())) json.member(slope.integrator, slope.slope);
  json.close_object();
  if (advice.chosen) {
    json.key("advice").open_object();
    add_score(json, *advice.chosen);
    json.key("found").open_object();
    add_score(json, advice.found);
    json.close_object().close_object();
  }
  json.key("cases").open_array();
  for (const Score* score : search_.scores()) {
    json.open_object();
    add_score(json, *score);
    json.close_object();
  }
  json.close_array().close_object();
  write_atomically(folder_ / "trade.json", json.text(), false);
}

void Trade::report() {
  write_csv();
  const References& references = scorer_.references();
  std::cout << table_text(search_.scores(), references);
  if (references.time)
    std::cout << "reference: " << references.time->which.label << "; uncertain by "
              << percent(references.check.uncertainty) << " (halving its step moves it by "
              << percent(references.check.moved) << ", sdirk2 is " << percent(references.check.apart) << " away)\n";
  if (references.mesh)
    std::cout << "finest mesh: " << references.mesh->which.label << "; total errors are uncertain by "
              << percent(references.total_uncertainty.rms) << '\n';
  for (const std::string& note : search_.notes()) std::cout << "note: " << note << '\n';
  draw({diagram()}, folder_ / "trade", options_.quiet);
  Advice advice;
  advise(advice);
  write_json(advice);
  std::cout << advice_text(advice);
}

}  // namespace app
