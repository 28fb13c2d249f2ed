// The numbers of a run, as it goes: probes.csv, steps.csv, contacts.csv.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/run/csv.h"
#include "app/run/run_folder.h"
#include "sim/contact/contact_report.h"
#include "sim/report.h"
#include "sim/system.h"

namespace app {

// All calls throw WriteError.
class RunLog {
 public:
  // From the start, or going on after `resumed_step`: rows of later steps are then cut off.
  RunLog(const sim::System& system, const std::vector<sim::Probe>& probes, const RunFolder& folder,
         std::optional<std::int64_t> resumed_step);

  // The initial state: a row of probes, none of steps.
  void start(const sim::State& state);
  // Returns what the contacts of the scene do after it.
  std::vector<sim::ContactReport> step(const sim::State& state, const sim::StepReport& report);
  // What is in the files survives from now on.
  void sync();
  void close();

 private:
  const sim::System& system_;
  int probe_count_;
  Csv probes_, steps_;
  std::optional<Csv> contacts_;  // where the scene has any [[contact]]
};

}  // namespace app
