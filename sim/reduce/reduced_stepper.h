// Steps a system in its basis: the coordinates are stepped, and the nodes follow.
#pragma once

#include <memory>

#include "sim/reduce/reduction.h"
#include "sim/time/scheme.h"
#include "sim/time/stepper.h"

namespace sim {

class ReducedStepper final : public Stepper {
 public:
  // The model of all nodes, and what it is reduced to.
  ReducedStepper(const Model& full, const Reduction& reduction, const Scheme& scheme, int threads);
  StepReport step(State& state) override;

 private:
  void measure_J(const State& state, StepReport& report);
  void note_J(const ElasticTerm& term, int body, const Eigen::VectorXd& x, Term::Store& store, StepReport& report);

  const Model& full_;
  const Reduction& reduction_;
  std::unique_ptr<Stepper> stepper_;  // of the coordinates
  State inner_;
  std::vector<std::unique_ptr<Term::Store>> stores_;  // of the elastic terms, for their J
  Eigen::VectorXd x_;                                 // of the sampled elements
};

}  // namespace sim
