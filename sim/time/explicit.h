// Steps an explicit scheme: forces and mass only, no matrix is formed.
//   symplectic-euler      v_{n+1} = v_n + h M^{-1} f(x_n),  x_{n+1} = x_n + h v_{n+1}
//   central-difference    v_{n+1/2} = v_n + h/2 M^{-1} f(x_n),  x_{n+1} = x_n + h v_{n+1/2},
//                         v_{n+1} = v_{n+1/2} + h/2 M^{-1} f(x_{n+1})     [velocity Verlet]
#pragma once

#include <optional>

#include "sim/solve/tangent_operator.h"
#include "sim/time/mass_solve.h"
#include "sim/time/scheme.h"
#include "sim/time/step_watch.h"
#include "sim/time/stepper.h"

namespace sim {

class ExplicitStepper final : public Stepper {
 public:
  ExplicitStepper(const Model& model, const Scheme& scheme, int threads);
  StepReport step(State& state) override;

 private:
  // next_ goes from t to t_end, which is h later.
  void advance(double t, double t_end, double h, StepReport& report);
  // v += s M^{-1} f on the free components
  void kick(double s, const Eigen::VectorXd& f, Eigen::VectorXd& v, StepReport& report);

  const Model& model_;
  const Scheme& scheme_;
  TangentOperator tangent_;
  MassSolve mass_;
  std::optional<StepWatch> watch_;  // where the step was chosen by what stability needs
  State next_;
  Eigen::VectorXd a_;
};

}  // namespace sim
