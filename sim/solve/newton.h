// Newton's method on the potential of one stage: minimises 1/2 |x - (x* + g h v*)|_M^2 + (g h)^2 U(x).
#pragma once

#include <functional>
#include <optional>

#include "sim/report.h"
#include "sim/solve/linear_solver.h"

namespace sim {

constexpr double step_share = 0.9;  // of the largest step that a term allows
constexpr int most_cuts = 40;       // of a step to its half, where it does not lower the potential

// One stage, in the variables of sim/time/scheme.h. Vectors have D numbers per node.
struct StageProblem {
  const Eigen::VectorXd& x_star;   // m
  const Eigen::VectorXd& v_start;  // sum c_k v_k [m/s]; M v* = M v_start + impulse
  const Eigen::VectorXd& impulse;  // h sum d_k f_k [kg m/s]
  double gh = 0;                   // s; 0 for a static problem: no mass, x is the unknown
  double t = 0;                    // s, at the end of the stage
  const Eigen::VectorXd& target;   // m: where prescribed components are at t; others mean nothing
  bool one_iteration = false;
  double barriers = 1;  // how often they count: Stage::barriers
};

class Newton {
 public:
  // interrupted: asked in each iteration; where it says so, solve() fails.
  Newton(const Model& model, int threads, std::function<bool()> interrupted = {});

  // Terms freeze what they keep for a step; the free components are those of time t_end of the step.
  // kept: the factor that the state at the start tells of.
  void begin_step(const Motion& start, double t_end, const KeptFactor& kept);
  // What the state at the step's end tells of.
  void keep(KeptFactor& kept) const;
  // x and v: the start of the iteration on entry; the stage's solution on return. Prescribed components that are not
  // yet where the stage has them, as something is in their way, are brought there first. start: the potential at the
  // start, if known. False, with report.failure, when the start is not allowed or a value is not finite.
  bool solve(const StageProblem& stage, std::optional<double> start, Eigen::VectorXd& x, Eigen::VectorXd& v,
             StepReport& report);
  // The stage's potential up to a constant [J]; +infinity where it is not allowed.
  double potential(const StageProblem& stage, const Motion& motion);

  // Since begin_step, an iteration ended as it made no progress: shorter steps may be solved.
  bool stuck() const { return stuck_; }
  // Since begin_step, solver.max_iterations ended an iteration that got on.
  bool cut_short() const { return cut_short_; }

  TangentOperator& tangent() { return tangent_; }

 private:
  bool is_interrupted(StepReport& report) const;
  int most_iterations(const StepReport& report) const;
  void form_residual(const StageProblem& stage, const Motion& motion);
  bool tangent_serves(const StageProblem& stage, const Motion& motion, StepReport& report);
  bool direction(const StageProblem& stage, const Motion& motion, Definiteness first, bool full_step_before,
                 double tolerance, StepReport& report);
  bool has_way_to_go(const StageProblem& stage, const Eigen::VectorXd& x);
  bool bring_prescribed(const StageProblem& stage, const Motion& motion, Eigen::VectorXd& x, Eigen::VectorXd& v,
                        StepReport& report);
  struct Move {
    double a;         // of dx_ that was taken
    double fall;      // of the potential, beyond its round-off [J]
    double promised;  // by the slope, for all of dx_ [J]
  };
  double noise_of(double potential) const;
  double longest(const StageProblem& stage) const;
  double lengthen(const StageProblem& stage, const Motion& motion, double before, double slope, double& potential_here,
                  Eigen::VectorXd& x, Eigen::VectorXd& v);
  Move line_search(const StageProblem& stage, const Motion& motion, double& potential_here, Eigen::VectorXd& x,
                   Eigen::VectorXd& v, StepReport& report);
  Move whole_step(const StageProblem& stage, Eigen::VectorXd& x, Eigen::VectorXd& v);
  double slope_at(const StageProblem& stage, const Motion& motion, StepReport& report);
  double largest_increment(const StageProblem& stage) const;
  void move(const StageProblem& stage, double a, Eigen::VectorXd& x, Eigen::VectorXd& v) const;
  bool turn(const StageProblem& stage, const Motion& motion, double a, Eigen::VectorXd& x, Eigen::VectorXd& v);
  // M (v - v_start) - impulse
  void inertia(const StageProblem& stage, const Eigen::VectorXd& v, Eigen::VectorXd& result);

  const Model& model_;
  std::function<bool()> interrupted_;
  Definiteness fix_;
  bool pure_;
  TangentOperator tangent_;
  std::unique_ptr<LinearSolver> linear_;
  Definiteness made_ = Definiteness::clamp;  // how the tangent of the latest direction was made definite
  bool stuck_ = false, cut_short_ = false;
  bool is_singular_ = false;   // the matrix of the latest direction: there is none
  bool kept_tangent_ = false;  // it is that of the iteration before
  double residual_norm_ = 0;   // there, N
  Eigen::VectorXd f_, residual_, dx_, x_from_, v_from_, difference_, product_;
  Eigen::VectorXd turned_;   // a part of dx_ that turns bodies
  Eigen::VectorXd way_;      // of prescribed components to their places
  Eigen::VectorXd v_given_;  // of prescribed components where these are at their places
  Eigen::VectorXd still_;    // no velocity
  enum class Way { none, drags, slides } way_kind_ = Way::none;  // what they do to what they touch while they are on it
};

}  // namespace sim
