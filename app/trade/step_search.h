// Finds the steps that a goal asks for: one run of each scheme, then that which its error or its time predicts.
#pragma once

#include <string>
#include <vector>

#include "app/trade/measurement.h"

namespace app {

// Steps a frame of a scheme of this order that bring an error, found with `substeps` of them, down to `aim`.
int substeps_for(double error, int substeps, int order, double aim);

class StepSearch {
 public:
  explicit StepSearch(Measurement& measurement) : m_(measurement) {}

  // Of every implicit scheme with one step a frame; with two or four where it fails so.
  void first_runs();
  // As many steps as the budget [s per simulated second] leaves room for.
  void fill(double budget);
  // The steps that bring the time error to `aim`, those first that will cost least; once more where it is missed.
  void reach(double aim);
  // Steps a frame with which a scheme is expected to have this error at most, by its finest run.
  int substeps(const std::string& scheme, double aim);

 private:
  // The finest run of a scheme so far.
  struct Latest {
    std::string scheme;
    int substeps;
    const CaseRun* run;
  };
  bool run(Latest& latest, int substeps);
  double error(const Latest& latest);
  int next_substeps(const Latest& latest, double aim);

  Measurement& m_;
  std::vector<Latest> latest_;
};

}  // namespace app
