// Every run of a trade: made when it is asked for, unless it lies in the folder from an earlier time.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <ostream>

#include "app/base/stopwatch.h"
#include "app/trade/run_case.h"

namespace app {

class Notebook {
 public:
  // `folder`: where the runs are kept (DIR/cases). `seconds`: of wall time that all runs may take. `out`: where
  // progress goes; nullptr: nowhere. Throws WriteError.
  Notebook(const Comparison& comparison, std::filesystem::path folder, double seconds, std::ostream* out,
           const Interrupt& interrupt);

  // The run of this case; it stays where it is. It may take `allowance` [s], but never more than is left of the time.
  const CaseRun& run(const TradeCase& which, double allowance);
  // Seconds that this case would take, from its first steps.
  double first_look(const TradeCase& which);
  // A run made anew, and not kept.
  CaseRun run_afresh(const TradeCase& which);
  // Cases that are not in the folder are from now on skipped for this reason.
  void recall_only(const std::string& reason) { recall_only_ = reason; }
  // The first steps of a run, timed anew.
  std::vector<sim::TimedStep> time_steps(const CaseRun& run, double seconds);
  // Lists a case as skipped without a try.
  void skip(const TradeCase& which, const std::string& reason);

  bool recalls_only() const { return !recall_only_.empty(); }
  double left() const { return seconds_ - watch_.seconds(); }
  double seconds() const { return seconds_; }
  const std::deque<CaseRun>& runs() const { return runs_; }
  // Called after every run.
  void on_change(std::function<void()> f) { changed_ = std::move(f); }
  void say(const std::string& line) const;

 private:
  CaseRun* known(std::uint64_t id);
  std::filesystem::path file(std::uint64_t id) const;
  void keep(const CaseRun& run) const;
  const CaseRun& add(CaseRun run);
  CaseRun told(CaseRun run) const;

  const Comparison& comparison_;
  std::filesystem::path folder_;
  double seconds_;
  std::ostream* out_;
  Stopwatch watch_;
  const Interrupt& interrupt_;
  std::deque<CaseRun> runs_;  // references stay valid
  std::string recall_only_;
  std::function<void()> changed_;
};

}  // namespace app
