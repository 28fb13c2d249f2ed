#include "app/trade/trade.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <thread>

#include "app/base/gnuplot.h"
#include "app/base/output_file.h"
#include "app/base/text.h"
#include "app/base/version.h"
#include "app/trade/advice.h"
#include "app/trade/named_cases.h"
#include "app/trade/side_by_side.h"
#include "app/trade/table.h"

namespace app {
namespace {

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
      named_(named_cases(comparison_, folder_)),
      notebook_(comparison_, cases_folder(options, folder_, comparison_.scene.identity), seconds,
                options.quiet ? nullptr : &std::cerr, interrupt),
      scorer_(comparison_),
      measurement_(comparison_, notebook_, scorer_, goal_, named_),
      search_(measurement_, folder_) {
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
  write_atomically(folder_ / "trade.csv", trade_csv(measurement_.scores(), comparison_), false);
}

Diagram Trade::diagram(const Advice& advice) {
  const Document& document = comparison_.scene.document;
  const References& references = scorer_.references();
  return {document.title.empty() ? options_.scene.stem().string() : document.title,
          measurement_.goal,
          measurement_.scores(),
          references.check.uncertainty,
          references.total_uncertainty.rms,
          advice.chosen,
          advice.chosen ? &advice.found : nullptr};
}

void draw(const std::vector<Diagram>& diagrams, const std::filesystem::path& base, bool quiet) {
  const auto all_have = [&](ErrorShown shown) {
    return std::ranges::all_of(diagrams, [&](const Diagram& diagram) { return has_errors(diagram, shown); });
  };
  std::vector<std::pair<ErrorShown, std::filesystem::path>> charts;
  if (all_have(ErrorShown::total)) charts.emplace_back(ErrorShown::total, base);
  if (all_have(ErrorShown::time))
    charts.emplace_back(ErrorShown::time, base.string() + (charts.empty() ? "" : "-time"));
  if (charts.empty()) std::cerr << "note: no diagram: no error is known\n";
  for (const auto& [shown, path] : charts) {
    const std::filesystem::path script = path.string() + ".gp";
    write_atomically(script, plot_script(make_chart(diagrams, shown), path), false);
    if (const std::string why = run_gnuplot(script); !why.empty())
      std::cerr << "note: no diagram: " << why << '\n';
    else if (!quiet)
      std::cerr << "diagram: " << path.string() << ".svg, .png\n";
  }
}

void Trade::show(const Advice& advice, const Interrupt& interrupt) {
  const std::vector<Shown> shown = choose_shown(measurement_, advice);
  const std::filesystem::path folder = folder_ / "show";
  draw_side_by_side(comparison_, shown, options_, folder, scorer_.references().check.frames, interrupt);
  const bool video = !options_.video.empty() && !options_.still;
  if (!options_.quiet) std::cerr << "side by side: " << (video ? options_.video : folder).string() << '\n';
}

// The run that checks the advice follows at once, so that the machine is what it was when its time was predicted.
Advice Trade::advise() {
  Advice advice;
  const std::vector<const Score*> scores = measurement_.scores();
  advice.own = &scorer_.score(notebook_.run(scene_case(), 0));
  advice.chosen = choose(scores, measurement_.goal);
  if (!advice.chosen) return advice;
  advice.fresh = std::make_unique<const CaseRun>(notebook_.run_afresh(advice.chosen->run->which));
  advice.found = scorer_.judge(*advice.fresh);
  // As its time was predicted: what it costs by itself. Whatever else ran, it cost no more than the least of these.
  const Work& work = advice.fresh->work;
  advice.found.seconds = std::min(work.least(), work.cpu);
  if (!advice.fresh->timed.empty())
    advice.found.seconds = std::min(advice.found.seconds, sim::unit_costs(advice.fresh->timed).of(work.counts()));
  const std::string comment = "ritz trade " + options_.scene.string() + ": for " + measurement_.goal.text + ": " +
                              advice.chosen->run->which.label;
  write_atomically(folder_ / "advice.toml", advice_toml(advice.chosen->run->which, comment), false);
  return advice;
}

void Trade::tell_load() {
  constexpr double noticed = 0.3;  // cores
  const auto others = load_.cores();
  if (!others || *others < noticed) return;
  measurement_.notes.push_back(
      formatted("other programs kept %.1f of %u cores busy meanwhile: ", *others, std::thread::hardware_concurrency()) +
      "times are counts of work times what each costs at the best, runs took longer");
}

Advice Trade::report() {
  Advice advice = advise();
  tell_load();
  const std::vector<const Score*> scores = measurement_.scores();
  write_csv();
  const References& references = scorer_.references();
  std::cout << table_text(scores, references);
  if (references.time)
    std::cout << "reference: " << references.time->which.label << "; uncertain by "
              << percent(references.check.uncertainty) << " (halving its step moves it by "
              << percent(references.check.moved) << ", sdirk2 is " << percent(references.check.apart) << " away)\n";
  if (references.mesh)
    std::cout << "finest mesh: " << references.mesh->which.label << "; total errors are uncertain by "
              << percent(references.total_uncertainty.rms) << '\n';
  std::string spent;
  for (const auto& [phase, seconds] : measurement_.spent)
    spent += (spent.empty() ? "" : ", ") + phase + formatted(" %.0f s", seconds);
  std::cout << "time was spent on: " << spent << '\n';
  for (const std::string& note : measurement_.notes) std::cout << "note: " << note << '\n';
  draw({diagram(advice)}, folder_ / "trade", options_.quiet);
  write_atomically(folder_ / "trade.json", trade_json(measurement_, search_.plan(), advice), false);
  std::cout << advice_text(measurement_, advice, folder_ / "advice.toml");
  return advice;
}

}  // namespace app
