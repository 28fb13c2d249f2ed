// Steps an implicit scheme: each stage is one minimisation. [mathematics.md 7]
#pragma once

#include "sim/solve/newton.h"
#include "sim/stepper.h"

namespace sim {

class ImplicitStepper final : public Stepper {
 public:
  ImplicitStepper(const System::Parts& parts, int threads);
  StepReport step(State& state) override;

 private:
  bool take_stage(const Scheme& scheme, const Stage& stage, int number, const Motion& begin, StepReport& report);
  void guess(const StageProblem& problem, const Scheme& scheme);
  bool finish(const Scheme& scheme, const Motion& begin, double t_end, StepReport& report);

  const System::Parts& parts_;
  Newton newton_;
  State next_;  // the step under way; the caller's state is untouched until it is done
  Eigen::VectorXd x_star_, v_start_, impulse_;
  Eigen::VectorXd x_first_, v_first_, force_first_;  // first stage of two
  Eigen::VectorXd x_, v_, force_;                    // the stage under way
};

}  // namespace sim
