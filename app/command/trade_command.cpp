// The command `ritz trade`.
#include <algorithm>
#include <iostream>
#include <memory>

#include "app/base/exit_code.h"
#include "app/base/folder.h"
#include "app/command/commands.h"
#include "app/record/video.h"
#include "app/scene/scene_items.h"
#include "app/trade/ablate.h"
#include "app/trade/trade.h"

namespace app {
namespace {

// Jobs are planned without a clock, so that every machine lists the same.
Plan job_plan(const Comparison& comparison) {
  return {4, comparison.scene.last_frame()};
}

std::vector<TradeCase> jobs_of(const Comparison& comparison) {
  return independent_cases(comparison.scene.document, job_plan(comparison), comparison.options.trade.keep_mesh);
}

int list_jobs(const Options& options) {
  int number = 0;
  for (const TradeCase& which : jobs_of(make_comparison(options))) std::cout << number++ << '\t' << which.label << '\n';
  return exit_done;
}

int run_one(const Options& options) {
  const Comparison comparison = make_comparison(options);
  const std::vector<TradeCase> jobs = jobs_of(comparison);
  const int number = *options.trade.one_case;
  if (number < 0 || number >= static_cast<int>(jobs.size()))
    throw std::runtime_error("--case " + std::to_string(number) + ": must be 0 to " + std::to_string(jobs.size() - 1) +
                             ", as --jobs lists them");
  const Interrupt interrupt;
  Notebook notebook(comparison, trade_folder(options) / "cases", 1e9, options.quiet ? nullptr : &std::cerr, interrupt);
  try {
    notebook.run(jobs[number], 1e9);
  } catch (const Interrupted&) {
    return exit_interrupted;
  }
  return exit_done;
}

// A file that says where a mesh comes from is a scene of its own; others lie over the scene.
bool is_scene(const std::filesystem::path& file) {
  return std::ranges::any_of(read_layer(file).items, [](const Item& item) {
    const std::string_view name = item.key->path;
    return name == "body[].mesh.box" || name == "body[].mesh.rectangle" || name == "body[].mesh.sheet" ||
           name == "body[].mesh.file";
  });
}

Options other_options(const Options& options) {
  Options other = options;
  if (is_scene(options.trade.compare)) {
    other.scene = options.trade.compare;
  } else if (options.settings.empty()) {
    other.settings = options.trade.compare;
  } else {
    throw std::runtime_error("--compare " + options.trade.compare.string() +
                             ": is a settings file, and --settings gives one already: leave one of them out");
  }
  return other;
}

int interrupted(const std::filesystem::path& folder) {
  std::cerr << "ritz: interrupted; the runs made so far are in " << (folder / "trade.csv").string()
            << ", the same command goes on from them\n";
  return exit_interrupted;
}

// Both scenes, each in half of the time, then one diagram.
int compare(const Options& options) {
  const std::filesystem::path folder = trade_folder(options);
  const Options others = other_options(options);
  make_comparison(others);  // what is wrong with it is said before anything is measured
  const Interrupt interrupt;
  const auto measured = [&](const Options& which, const char* name) {
    auto trade = std::make_unique<Trade>(which, folder / name, trade_seconds(options.trade) / 2, interrupt);
    if (trade->measure(std::nullopt)) return trade;
    trade.reset();
    return trade;
  };
  const auto one = measured(options, "one");
  if (!one) return interrupted(folder);
  const Advice first_advice = one->report();
  const auto other = measured(others, "other");
  if (!other) return interrupted(folder);
  const Advice second_advice = other->report();
  Diagram first = one->diagram(first_advice), second = other->diagram(second_advice);
  if (first.name == second.name) {
    first.name += ", as it is";
    second.name += ", " + options.trade.compare.stem().string();
  }
  draw({first, second}, folder / "compare", options.quiet);
  return exit_done;
}

}  // namespace

int trade(const Options& options) {
  // What can be seen to be wrong now is not found after minutes of measuring.
  if (!options.video.empty() && !options.still) require_video_name(options.video, options.overwrite);
  if (options.trade.jobs) return list_jobs(options);
  if (options.trade.one_case) return run_one(options);
  if (options.trade.ablate) return ablate(options);
  if (!options.trade.compare.empty()) return compare(options);
  const std::filesystem::path folder = trade_folder(options);
  if (const std::string why = why_no_folder(folder); options.trade.collect && !why.empty())
    throw std::runtime_error(folder.string() + ": " + why + ", so there is nothing to collect");
  const Interrupt interrupt;
  Trade trade(options, folder, trade_seconds(options.trade), interrupt);
  if (options.trade.collect) {
    const Comparison comparison = make_comparison(options);
    trade.collect(job_plan(comparison));
  } else if (!trade.measure(std::nullopt)) {
    return interrupted(folder);
  }
  const Advice advice = trade.report();
  if (!options.trade.show) return exit_done;
  try {
    trade.show(advice, interrupt);
  } catch (const Interrupted&) {
    return exit_interrupted;
  }
  return exit_done;
}

}  // namespace app
