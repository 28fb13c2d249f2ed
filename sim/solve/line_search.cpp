// How far Newton's method goes along a direction.
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/solve/newton.h"
#include "sim/solve/turning.h"

namespace sim {

namespace {

constexpr double armijo = 1e-4;     // share of the predicted decrease that a step must give
constexpr double by_slopes = 0.25;  // the same, told by the slopes at both ends: where there is a kink, less is luck
constexpr double straight = 0.8;    // share of the promised fall; a tangent that is right gives half
constexpr double energy_noise = 1e-14;  // round-off of the stage's potential, relative to its parts

}  // namespace

// Round-off of the stage's potential, relative to the largest of its parts that are known.
double Newton::noise_of(double potential) const {
  return energy_noise * (model_.energy_scale + 10 * std::abs(potential));
}

// dx . grad of the potential at the motion; residual_ is that of the motion then.
double Newton::slope_at(const StageProblem& stage, const Motion& motion, StepReport& report) {
  tangent_.forces(motion, f_);
  ++report.force_evaluations;
  form_residual(stage, motion);
  return -residual_.dot(dx_);
}

// Armijo backtracking; the step taken is 0 when none decreases the potential. Where the step changes it by so little
// that the round-off of much deformed elements may decide, the slopes at both ends tell instead: the fall of a parabola
// is their mean times the step. ["approximate Wolfe", Hager and Zhang 2005]
Newton::Move Newton::line_search(const StageProblem& stage, const Motion& motion, double& potential_here,
                                 Eigen::VectorXd& x, Eigen::VectorXd& v, StepReport& report) {
  constexpr double too_fine = 1e-10;  // change of the potential, relative to its parts
  const double slope = -residual_.dot(dx_);
  const double before = potential_here;
  const double limit = tangent_.largest_step(motion, dx_);
  double a = limit < 1 ? step_share * limit : 1;
  x_from_ = x;
  v_from_ = v;
  const double noise = noise_of(before), fine = too_fine * (model_.energy_scale + std::abs(before));
  for (int k = 0; k <= most_cuts; ++k, a *= 0.5) {
    move(stage, a, x, v);
    potential_here = potential(stage, motion);
    const double fall = before - potential_here - noise;
    if (fall >= -armijo * a * slope - 2 * noise) {
      const bool plane =
          !pure_ && a == 1 && fall > straight * -slope && largest_increment(stage) > model_.solver.tolerance;
      if (plane) a = lengthen(stage, motion, before, slope, potential_here, x, v);
      return {a, before - potential_here - noise, -slope};
    }
    // Along a line it does not go so far, but a body that turns may get there.
    if (turn(stage, motion, a, x, v)) {
      potential_here = potential(stage, motion);
      const double turned_fall = before - potential_here - noise;
      if (turned_fall >= -armijo * a * slope) return {a, turned_fall, -slope};
      move(stage, a, x, v);
      potential_here = before - fall - noise;
    }
    if (potential_here <= before + fine) {
      const double there = slope_at(stage, motion, report);
      if (there <= (2 * by_slopes - 1) * slope) return {a, -a * (slope + there) / 2, -slope};
    }
    ++report.backtracks;
  }
  move(stage, 0, x, v);
  potential_here = before;
  return {0, 0, -slope};
}

// Goes the part a of dx_ with bodies that turn. False, and stays: none does, or something is in their way.
bool Newton::turn(const StageProblem& stage, const Motion& motion, double a, Eigen::VectorXd& x, Eigen::VectorXd& v) {
  constexpr double least = 1e-3;  // radian: it stretches by less than is worth a potential
  if (pure_) return false;
  product_ = a * dx_;
  if (!turn_along(model_, tangent_.free(), least, x_from_, product_, turned_)) return false;
  move(stage, 0, x, v);
  if (tangent_.largest_step(motion, turned_) < 1) {
    move(stage, a, x, v);
    return false;
  }
  dx_.swap(turned_);
  move(stage, 1, x, v);
  dx_.swap(turned_);
  return true;
}

// How often dx_ may be taken at once. What is in the way could be gone around by a few long moves, each of them free:
// by nothing that is longer than barriers are wide.
double Newton::longest(const StageProblem& stage) const {
  constexpr double width = 1e-3;  // of a body's size
  if (!tangent_.limits_moves()) return std::numeric_limits<double>::infinity();
  return width / (largest_increment(stage) * (stage.gh == 0 ? 1 : stage.gh));
}

// A whole step has lowered the potential almost as if it were a plane: the tangent, made definite, is too stiff along
// dx_. Goes on to where the parabola through slope and fall is lowest,
//   fall(a) = promised (a - c a^2):  a = 1/(2c),
// or less far, where it is no lower there, as long as that lowers it further, and no further than terms allow. Returns
// the step.
double Newton::lengthen(const StageProblem& stage, const Motion& motion, double before, double slope,
                        double& potential_here, Eigen::VectorXd& x, Eigen::VectorXd& v) {
  constexpr int most_tries = 10;
  constexpr double most_at_once = 16, worth_it = 1.5;  // times as long
  const double noise = noise_of(before), most = longest(stage);
  double a = 1;
  for (int k = 0; k < most_tries; ++k) {
    const double share = (before - potential_here - noise) / (a * -slope);
    double longer = share < 1 ? std::min(1 / (2 * (1 - share)), most_at_once) : most_at_once;
    longer = std::min(longer, most / a);
    product_ = (longer - 1) * a * dx_;
    if (longer < worth_it || tangent_.largest_step(motion, product_) < 1) break;
    double after = potential_here;
    bool as_far_as_it_looks = true;
    for (; longer >= worth_it; longer = std::sqrt(longer), as_far_as_it_looks = false) {
      move(stage, longer * a, x, v);
      after = potential(stage, motion);
      if (after < potential_here) break;
    }
    if (longer < worth_it) {
      move(stage, a, x, v);
      break;
    }
    potential_here = after;
    a *= longer;
    if (!as_far_as_it_looks) break;
  }
  return a;
}

}  // namespace sim
