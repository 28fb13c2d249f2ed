// How Newton's method brings pins and obstacles to where they are prescribed, where bodies are in their way.
#include <algorithm>

#include "sim/solve/newton.h"
#include "sim/solve/pressed.h"

namespace sim {

// way_: from x to the places of prescribed components; false where all are there.
bool Newton::has_way_to_go(const StageProblem& stage, const Eigen::VectorXd& x) {
  way_ = (tangent_.free().array() == 0).select(stage.target - x, 0);
  return way_.squaredNorm() > 0;
}

// Prescribed components go to their places as far as nothing stops them, and the others as the linear system says that
// they follow: (K dx)_free = r - (K way)_free. What is pushed so makes room, and more of the way is free. Nothing need
// fall meanwhile: what moves the prescribed components does work. False, with report.failure: they do not arrive.
bool Newton::bring_prescribed(const StageProblem& stage, const Motion& motion, Eigen::VectorXd& x, Eigen::VectorXd& v,
                              StepReport& report) {
  constexpr int most_moves = 200;
  // Surfaces that touch must move together to a small part of their gap, which is a tiny part of the way.
  constexpr double tight = 1e-9;
  // Of the way, so much is asked for at a time as was free the last time, or twice that: what is pressed gives way by
  // as much as it must. Where all of the way was asked for and a hundredth of it was free, a hundredth of what opens
  // the gaps was taken as well, and they closed from move to move.
  constexpr double least_share = 0.02;  // what stops a body that moves by itself must not stop the way
  // Body sizes. Where less is free some times in a row, there is no room: gaps would close until they are round-off.
  constexpr double no_room = 1e-7;
  constexpr int most_idle = 3;
  double share = 1;
  int idle = 0;
  // Their velocities grow along the way as positions do, up to those of its end: friction and damping then ask for what
  // the linear system gives. Were they at the end's from the start, all that they drag would go twice as far.
  const bool obstacles_move = !way_.tail((model_.node_count - model_.body_nodes) * model_.D).isZero(0);
  v_given_ = v;
  if (stage.gh != 0) v -= way_ / stage.gh;
  for (int k = 0; has_way_to_go(stage, x); ++k) {
    way_ *= share;
    // Obstacles slide along what they touch, which is to make room, and so do pins once what they drag has run into
    // something: friction and damping act when all is at its place.
    way_kind_ = k == 0 && !obstacles_move ? Way::drags : Way::slides;
    if (is_interrupted(report)) return false;
    const bool found = direction(stage, motion, fix_, false, tight, report);
    way_kind_ = Way::none;
    if (k == most_moves || idle == most_idle || !found) {
      report.failure = pressed_text(model_, motion, way_);
      return false;
    }
    ++report.newton;
    dx_ += way_;
    const double limit = tangent_.largest_step(motion, dx_);
    double a = limit < 1 ? step_share * limit : 1;
    const bool arrives = a == 1 && share == 1;
    idle = !arrives && a * way_.lpNorm<Eigen::Infinity>() < no_room * model_.node_size.minCoeff() ? idle + 1 : 0;
    share = std::clamp(a < 1 ? a * share : 2 * share, least_share, 1.0);
    x_from_ = x;
    v_from_ = v;
    move(stage, a, x, v);
    for (int halvings = 0; !std::isfinite(potential(stage, motion)) && halvings < most_cuts; ++halvings) {
      a /= 2;
      move(stage, a, x, v);
      ++report.backtracks;
    }
    if (arrives && a == 1)
      for (Eigen::Index i = 0; i < x.size(); ++i)
        if (tangent_.free()[i] == 0) {
          x[i] = stage.target[i];
          v[i] = v_given_[i];
        }
  }
  return true;
}

}  // namespace sim
