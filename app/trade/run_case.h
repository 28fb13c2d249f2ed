// Runs a case: steps it over the comparison's stretch, without drawing and files, and times it.
#pragma once

#include "app/base/interrupt.h"
#include "app/trade/comparison.h"

namespace app {

// What the user's Ctrl+C throws out of a case.
struct Interrupted {};

struct Allowance {
  double run = 0;         // s: a run that would take longer is given up, as skipped, once that is clear
  double repeat = 0;      // s: runs that take less than this are repeated and timed three times
  double patience = 0.3;  // s of a run before its length is judged
};

// The simulation is the comparison's scene with the case's settings. Throws Interrupted; numerical failures are
// results.
CaseRun run_case(const Comparison& comparison, const TradeCase& which, const Simulation& simulation,
                 const Allowance& allowance, const Interrupt& interrupt);

// The run of a case whose settings do not go together.
CaseRun refused_case(const TradeCase& which, const std::string& reason);

// Steps from the beginning for so many seconds, or to the end, and how long each took.
std::vector<sim::TimedStep> timed_steps(const Comparison& comparison, const TradeCase& which,
                                        const Simulation& simulation, double seconds, const Interrupt& interrupt);

}  // namespace app
