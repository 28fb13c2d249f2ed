// Steps an implicit scheme: each stage is one minimisation. [mathematics.md 7]
#pragma once

#include <functional>
#include <optional>

#include "sim/mesh/input_error.h"
#include "sim/solve/newton.h"
#include "sim/time/energy_limit.h"
#include "sim/time/scheme.h"
#include "sim/time/stepper.h"

namespace sim {

// What is done with a step whose equations are not solved: take it again in halves, accept it, or stop.
class ImplicitStepper final : public Stepper {
 public:
  ImplicitStepper(const Model& model, const Scheme& scheme, int threads, std::function<bool()> interrupted = {});
  StepReport step(State& state) override;

 private:
  // A step, or a part of one: from t to t_end = t + h. Depth: how often it was halved.
  struct Interval {
    double t, t_end, h;
    int depth;
  };
  bool advance(const Interval& interval, StepReport& report);
  const Scheme& scheme_of(const Interval& interval, const StepReport& report) const;
  bool attempt(const Interval& interval, const Scheme& scheme, const State& begin, StepReport& report);
  bool take_stage(const Scheme& scheme, const Stage& stage, int number, double h, double t_begin, StepReport& report);
  std::optional<double> guess(const StageProblem& problem, const Scheme& scheme, double h);
  bool flight_turns(const StageProblem& problem);
  bool limit_guess(const StageProblem& problem);
  void find_force(const StageProblem& problem);
  void leave_out_barriers(const StageProblem& problem);
  void finish(const Scheme& scheme, const Motion& begin, double t_end);

  const Model& model_;
  const Scheme& scheme_;
  Newton newton_;
  EnergyLimit limit_;
  bool may_gain_;             // bodies may hit something
  bool in_vain_ = false;      // halving did not help in the step under way
  State next_;                // the step under way; the caller's state is untouched until it is done
  std::vector<State> begin_;  // where the step, and its halves, began; by depth
  Eigen::VectorXd x_star_, v_start_, impulse_, way_, turned_, target_;
  Eigen::VectorXd x_first_, v_first_, force_first_;  // first stage of two
  Eigen::VectorXd x_, v_, force_;                    // the stage under way
  Eigen::VectorXd barrier_impulse_;                  // in the stage before, kg m/s
  Eigen::VectorXd x_lagged_, v_lagged_;              // where the terms froze what they keep, if not at the start
};

}  // namespace sim
