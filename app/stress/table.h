// The table of stability that `ritz stress` prints, and its CSV.
#pragma once

#include <string>
#include <vector>

#include "app/stress/case.h"
#include "sim/study/recovery.h"

namespace app {

// What came of a case.
struct CaseResult {
  sim::Recovery recovery;
  std::string refused;  // why its scene could not be built; empty: it was run
  std::string locking;  // what its system remarks about it; empty: nothing
  double seconds = 0;
};

std::string table_header();
// One line, without the end: verdict, distance from rest, smallest J, inverted elements, steps not converged and
// halved, Newton iterations a step, seconds; gain of energy where it was looked for, and whether locking is remarked.
std::string table_row(const StabilityCase& c, const CaseResult& result);
// Counts of the verdicts, and what the reasons were; lines with their ends.
std::string table_summary(const std::vector<StabilityCase>& cases, const std::vector<CaseResult>& results);

std::string stability_csv(const std::vector<StabilityCase>& cases, const std::vector<CaseResult>& results);

}  // namespace app
