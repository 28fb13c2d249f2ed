#include "app/trade/ablate.h"

#include <algorithm>
#include <iostream>
#include <limits>

#include "app/base/exit_code.h"
#include "app/base/number_text.h"
#include "app/base/output_file.h"
#include "app/base/text.h"
#include "app/trade/costs.h"
#include "app/trade/features.h"
#include "app/trade/score.h"
#include "app/trade/side_by_side.h"
#include "app/trade/trade.h"

namespace app {
namespace {

constexpr double unseen = 0.5;  // pixels

// The scene without one feature, against the scene.
struct Removal {
  const CaseRun* run = nullptr;
  double saved = 0;  // share of what the scene costs
  Apart change;
};

std::string line(const Removal& removal) {
  const CaseRun& run = *removal.run;
  if (run.status != CaseStatus::done) return "  " + run.which.label + ": " + run.reason + '\n';
  const char* const verdict = removal.change.pixels < unseen ? "nothing that is seen: it can go" : "";
  return formatted("  %-46s %8.1f %10.3g %10.3g %10.3g  %s\n", run.which.label.c_str(), 100 * removal.saved,
                   100 * removal.change.rms, 100 * removal.change.max, removal.change.pixels, verdict);
}

std::string csv_line(const Removal& removal) {
  std::string text = quoted_field(removal.run->which.label);
  for (const double x :
       {removal.run->work.least(), removal.saved, removal.change.rms, removal.change.max, removal.change.pixels}) {
    text += ',';
    if (removal.run->status == CaseStatus::done) append_number(text, x);
  }
  return text + '\n';
}

// As much of the scene as all runs can be made over in the time.
void settle_stretch(Comparison& comparison, Notebook& notebook, std::size_t runs) {
  constexpr double margin = 2;  // motion is slow at first; some settings are slower than the scene's
  const double look = notebook.first_look(scene_case());
  const double share = notebook.left() / (margin * look * static_cast<double>(runs));
  if (share >= 1) return;
  const auto frames = static_cast<std::int64_t>(share * static_cast<double>(comparison.scene.last_frame()));
  comparison.stretch = stretch_of(comparison, std::max<std::int64_t>(frames, 1));
  std::cout << "note: only the first " << comparison.seconds()
            << " s are run: more does not fit into the time (--minutes)\n";
}

// The features that --show names, by any part of what the table calls them; all of them without a name.
std::vector<TradeCase> named_features(const std::vector<TradeCase>& all, const std::vector<std::string>& names) {
  if (names.empty()) return all;
  std::vector<TradeCase> found;
  for (const std::string& name : names) {
    const std::size_t before = found.size();
    for (const TradeCase& which : all)
      if (which.label.find(name) != std::string::npos) found.push_back(which);
    if (found.size() > before) continue;
    std::string there;
    for (const TradeCase& which : all) there += (there.empty() ? "" : "; ") + which.label;
    throw std::runtime_error("--show " + name + ": no feature of the scene is called so: " + there);
  }
  return found;
}

// Every case beside the scene.
std::vector<Removal> removals_of(const std::vector<TradeCase>& cases, const CaseRun& whole, Comparison& comparison,
                                 Notebook& notebook) {
  Scorer scorer(comparison);
  References references;
  references.check.frames = whole.path.frames();
  scorer.set(references);
  std::vector<Removal> removals;
  for (const TradeCase& which : cases) {
    const CaseRun& run = notebook.run(which, notebook.left());
    removals.push_back({&run, 0, {}});
    if (run.status == CaseStatus::done) removals.back().change = scorer.apart(run, whole);
  }
  std::ranges::stable_sort(removals, {}, [](const Removal& r) { return r.change.pixels; });
  return removals;
}

// The scene at the left, and beside it what it is without a feature.
void show_removals(const std::vector<Removal>& removals, const CaseRun& whole, const Costs& costs,
                   const Comparison& comparison, const Options& options, const Interrupt& interrupt) {
  const auto seconds = [&](const CaseRun& run) { return formatted("%.2g s", costs.seconds(run)); };
  std::vector<Shown> shown = {{"the scene as it is", seconds(whole), &whole}};
  for (const Removal& removal : removals)
    if (removal.run->status == CaseStatus::done)
      shown.push_back(
          {"without " + removal.run->which.label,
           percent(removal.change.rms) + formatted(" (%.2g px), ", removal.change.pixels) + seconds(*removal.run),
           removal.run});
  draw_side_by_side(comparison, shown, options, trade_folder(options) / "show", std::numeric_limits<int>::max(),
                    interrupt);
}

}  // namespace

int ablate(const Options& options) {
  const Interrupt interrupt;
  Comparison comparison = make_comparison(options);
  const std::filesystem::path folder = trade_folder(options);
  const std::vector<TradeCase> cases =
      named_features(without_features(comparison.scene.document), options.trade.show_names);
  Notebook notebook(comparison, folder / "cases", trade_seconds(options.trade), options.quiet ? nullptr : &std::cerr,
                    interrupt);
  try {
    settle_stretch(comparison, notebook, cases.size() + 1);
    const CaseRun& whole = notebook.run(scene_case(), notebook.left());
    if (whole.status != CaseStatus::done) throw std::runtime_error(options.scene.string() + ": " + whole.reason);
    std::vector<Removal> removals = removals_of(cases, whole, comparison, notebook);
    const Costs costs(notebook.runs(), {});
    std::string table =
        formatted("  %-46s %8s %10s %10s %10s\n", "the scene without", "saves %", "changes %", "at most %", "pixels");
    std::string csv = "without,seconds_per_second,saved,change,change_max,change_pixels\n";
    for (Removal& removal : removals) {
      removal.saved = 1 - costs.seconds(*removal.run) / costs.seconds(whole);
      table += line(removal);
      csv += csv_line(removal);
    }
    write_atomically(folder / "ablate.csv", csv, false);
    std::cout << table;
    if (options.trade.show) show_removals(removals, whole, costs, comparison, options, interrupt);
  } catch (const Interrupted&) {
    return exit_interrupted;
  }
  return exit_done;
}

}  // namespace app
