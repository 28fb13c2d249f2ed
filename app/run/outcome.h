// What a run has come to.
#pragma once

#include <cstdint>
#include <string>

#include "app/options/options.h"
#include "app/run/run_folder.h"
#include "app/run/state_file.h"
#include "app/scene/simulation.h"
#include "sim/report.h"

namespace app {

enum class Status { running, done, interrupted, failed };

struct Outcome {
  Status status = Status::running;
  sim::StepReport failure;           // failed: of the step that could not be taken, or else
  std::string error;                 // what else ended the run: a file that could not be written
  SavedRun run;                      // with the last good state
  int inverted = 0;                  // elements after the last step
  std::string not_converged_reason;  // of the first step that did not converge, if one did not
  std::string overlap;               // which bodies go through each other, and since when; empty: none
  std::int64_t braked = 0;           // steps that would have made energy of nothing
  bool no_factor = false;            // there was no memory for the matrix's factor
  std::int64_t resumed_step = -1;    // step that the run went on after; -1: none
  // s: taking steps, and of these in matrices and in solvers; building and the whole run
  double stepping = 0, assembling = 0, solving = 0, total = 0;

  // Counts a step. False when it could not be taken: the state is then the last good one.
  bool add(const sim::StepReport& report);
};

// The exit code. Says on stderr why a run ended early, and, unless quiet, whether steps did not converge.
int conclude(const Simulation& simulation, const Options& options, const RunFolder& folder, const Outcome& outcome);

}  // namespace app
