// The command `ritz trade`.
#include <iostream>

#include "app/commands.h"
#include "app/trade/trade.h"

namespace app {
namespace {

// Jobs are planned without a clock, so that every machine lists the same.
Plan job_plan(const Ground& ground) {
  return {4, ground.scene.last_frame()};
}

std::vector<Case> jobs_of(const Ground& ground) {
  return independent_cases(ground.scene.document, job_plan(ground), ground.options.trade.keep_mesh);
}

int list_jobs(const Options& options) {
  int number = 0;
  for (const Case& which : jobs_of(make_ground(options))) std::cout << number++ << '\t' << which.label << '\n';
  return kDone;
}

int run_one(const Options& options) {
  const Ground ground = make_ground(options);
  const std::vector<Case> jobs = jobs_of(ground);
  const int number = *options.trade.one_case;
  if (number < 0 || number >= static_cast<int>(jobs.size()))
    throw std::runtime_error("--case " + std::to_string(number) + ": must be 0 to " + std::to_string(jobs.size() - 1) +
                             ", as --jobs lists them");
  Notebook notebook(ground, trade_folder(options) / "cases", 1e9, options.quiet ? nullptr : &std::cerr);
  try {
    notebook.run(jobs[number], 1e9);
  } catch (const Interrupted&) {
    return kInterrupted;
  }
  return kDone;
}

}  // namespace

int trade(const Options& options) {
  if (options.trade.jobs) return list_jobs(options);
  if (options.trade.one_case) return run_one(options);
  const std::filesystem::path folder = trade_folder(options);
  Trade trade(options, folder, trade_seconds(options.trade));
  if (options.trade.collect) {
    const Ground ground = make_ground(options);
    trade.collect(job_plan(ground));
  } else if (!trade.measure(std::nullopt)) {
    std::cerr << "ritz: interrupted; the runs made so far are in " << (folder / "trade.csv").string()
              << ", the same command goes on from them\n";
    return kInterrupted;
  }
  trade.report();
  return kDone;
}

}  // namespace app
