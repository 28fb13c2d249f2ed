#include "sim/study/recovery.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/build/parts.h"
#include "sim/math/rigid_fit.h"
#include "sim/mesh/components.h"
#include "sim/mesh/tangle.h"
#include "sim/stepper.h"

namespace sim {

namespace {

Eigen::Matrix3Xd positions(const Eigen::VectorXd& x, const BodyRange& range, int D) {
  Eigen::Matrix3Xd p = Eigen::Matrix3Xd::Zero(3, range.node_count);
  p.topRows(D) =
      x.segment(static_cast<Eigen::Index>(range.first_node) * D, static_cast<Eigen::Index>(range.node_count) * D)
          .reshaped(D, range.node_count);
  return p;
}

// Largest |q_i - (R p_i + t)| with the R, t that fit best.
double misfit(const Eigen::Matrix3Xd& p, const Eigen::Matrix3Xd& q, const Eigen::VectorXd& m,
              const std::vector<int>& nodes, int D) {
  const RigidFit fit = fit_rigid(p, q, m, nodes, D);
  double largest = 0;
  for (const int i : nodes) largest = std::max(largest, (q.col(i) - fit.place(p.col(i))).norm());
  return largest;
}

}  // namespace

double shape_distance(const System& system, const Eigen::VectorXd& x, const Eigen::VectorXd& x_other) {
  const Model& model = parts_of(system).model;
  double largest = 0;
  for (std::size_t b = 0; b < model.ranges.size(); ++b) {
    const BodyRange& range = model.ranges[b];
    const Eigen::Matrix3Xd p = positions(x_other, range, model.D), q = positions(x, range, model.D);
    for (const Component& part : components(*range.mesh))
      largest = std::max(largest, misfit(p, q, model.masses[b].nodal(), part.nodes, model.D) / range.size);
  }
  return largest;
}

int wound_places(const System& system, const Eigen::VectorXd& x) {
  const Model& model = parts_of(system).model;
  int wound = 0;
  for (const BodyRange& range : model.ranges)
    for (const Component& part : components(*range.mesh))
      wound += Tangle(*range.mesh, part, range.first_node, model.D).count(x).wound;
  return wound;
}

namespace {

// Time in which a wave of stretch runs through the largest body, over h: what a step should resolve [steps].
double steps_per_wave(const System& system) {
  const Model& model = parts_of(system).model;
  double mass = 0, size = 0;
  for (const Mass& m : model.masses) mass += m.total();
  for (const BodyRange& range : model.ranges) size = std::max(size, range.size);
  return size * std::sqrt(mass / model.energy_scale) / model.h();
}

// When the last script of the scene ends [s].
double script_end(const Model& model) {
  double end = 0;
  for (const Body& body : model.bodies) {
    for (const Pin& pin : body.pins)
      end = std::max({end, pin.motion.empty() ? 0 : pin.motion.back().t, pin.release.value_or(0)});
    end = std::max(end, body.loads.risen());
  }
  return end;
}

// Tells at every tenth step whether the shapes still change; under loads, whether anything moves: a falling body keeps
// its shape.
class RestDetector {
 public:
  RestDetector(const System& system, const State& state, bool loaded)
      : system_(system),
        x_(state.x),
        loaded_(loaded),
        per_wave_(steps_per_wave(system)),
        script_end_(script_end(parts_of(system).model)) {}

  void look(const State& state) {
    if (state.step % every != 0) return;
    double moved = shape_distance(system_, state.x, x_);
    if (loaded_)
      moved = std::max(moved, (state.x - x_).cwiseAbs().maxCoeff() / parts_of(system_).model.node_size.minCoeff());
    moved_ = moved / every * std::max(1.0, per_wave_);
    x_ = state.x;
    quiet_ = moved_ < 1e-9 && system_.time(state.step) > script_end_ ? quiet_ + 1 : 0;
  }
  bool settled() const { return moved_ < 1e-5; }
  bool dead() const { return quiet_ >= 3; }

 private:
  static constexpr int every = 10;
  const System& system_;
  Eigen::VectorXd x_;
  bool loaded_;
  double per_wave_, script_end_;
  double moved_ = 1;  // in the time of a wave or of a step, whichever is longer [body sizes]
  int quiet_ = 0;
};

// How far the energy rises above what it was.
class Gain {
 public:
  // stiff: Young's modulus times volume [J], of which a thousandth is no round-off.
  Gain(const Measures& start, double stiff)
      : start_(total(start)), most_(std::max(100 * (start.kinetic + start.elastic), 1e-3 * stiff)) {
    look(start);
  }
  void look(const Measures& now) {
    const double rise = total(now) - start_;
    rise_ = std::max(rise_, rise);
    above_ = rise > most_ ? above_ + 1 : 0;
    scale_ = std::max(scale_, now.kinetic + now.elastic);
  }
  double share() const { return scale_ > 0 ? rise_ / scale_ : 0; }
  // A first step may leap further, and come back.
  bool runs_away() const { return above_ >= 50; }

 private:
  static double total(const Measures& m) { return m.kinetic + m.elastic + m.potential; }
  double start_, most_, rise_ = 0, scale_ = 0;  // J
  int above_ = 0;                               // looks in a row
};

void add(const StepReport& report, Recovery& r) {
  r.min_J = r.steps == 0 ? report.min_J : std::min(r.min_J, report.min_J);
  r.inverted = report.inverted;
  ++r.steps;
  r.splits += report.splits;
  r.newton += report.newton;
  r.linear += report.linear;
  if (report.converged) return;
  if (r.not_converged++ == 0) r.reason = report.reason;
}

}  // namespace

void Recovery::then(const Recovery& later) {
  verdict = later.verdict;
  failure = later.failure;
  if (reason.empty()) reason = later.reason;
  distance = later.distance;
  min_J = std::min(min_J, later.min_J);
  inverted = later.inverted;
  wound = later.wound;
  steps += later.steps;
  not_converged += later.not_converged;
  splits += later.splits;
  newton += later.newton;
  linear += later.linear;
  if (later.gain) gain = std::max(gain.value_or(0), *later.gain);
}

Recovery recover(const System& system, State& state, std::int64_t steps, const RecoveryOptions& options,
                 const std::function<bool()>& interrupted) {
  constexpr double near = 1e-4;
  constexpr int most_unsolved = 50;  // steps in a row
  const auto stepper = make_stepper(system, 1);
  const std::int64_t end = state.step + steps;
  RestDetector rest(system, state, options.loaded);
  std::optional<Gain> gain;
  if (options.energy) gain.emplace(system.measure(state), parts_of(system).model.energy_scale);
  Recovery r;
  int unsolved = 0;
  while (state.step < end && !rest.dead() && r.failure.empty() && unsolved < most_unsolved && !interrupted()) {
    const StepReport report = stepper->step(state);
    if (report.failure.empty()) {
      add(report, r);
      rest.look(state);
      if (gain) gain->look(system.measure(state));
      if (gain && gain->runs_away())
        r.failure = "step " + std::to_string(state.step) +
                    ": its energy has been a hundred times that of its start for 50 steps";
      unsolved = report.converged ? 0 : unsolved + 1;
    } else {
      r.failure = failure_text(system, report);
    }
  }
  r.distance = shape_distance(system, state.x, parts_of(system).model.X);
  r.wound = wound_places(system, state.x);
  if (gain) r.gain = gain->share();
  if (!r.failure.empty())
    r.verdict = Verdict::stopped;
  else if (!rest.settled())
    r.verdict = unsolved > 0 ? Verdict::iterating : Verdict::moving;
  else if (options.loaded)
    r.verdict = Verdict::at_rest_loaded;
  else
    r.verdict = r.distance <= near ? Verdict::recovered : Verdict::other_equilibrium;
  return r;
}

}  // namespace sim
