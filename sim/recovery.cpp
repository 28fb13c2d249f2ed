#include "sim/recovery.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>
#include <numeric>
#include <sstream>
#include <vector>

#include "sim/parts.h"
#include "sim/stepper.h"

namespace sim {

namespace {

// The number of the lowest node that is connected with each node of the mesh.
std::vector<int> connected_parts(const Mesh& mesh) {
  std::vector<int> root(mesh.node_count());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& nodes : mesh.elements.colwise())
    for (const int node : nodes) {
      const int a = find(node), b = find(nodes[0]);
      root[std::max(a, b)] = std::min(a, b);
    }
  for (int i = 0; i < mesh.node_count(); ++i) root[i] = find(i);
  return root;
}

Eigen::Matrix3Xd positions(const Eigen::VectorXd& x, const BodyRange& range, int D) {
  Eigen::Matrix3Xd p = Eigen::Matrix3Xd::Zero(3, range.node_count);
  p.topRows(D) =
      x.segment(static_cast<Eigen::Index>(range.first_node) * D, static_cast<Eigen::Index>(range.node_count) * D)
          .reshaped(D, range.node_count);
  return p;
}

// Largest |q_i - (R p_i + t)| with R, t that minimise sum m_i |q_i - (R p_i + t)|^2 over the given nodes.
double misfit(const Eigen::Matrix3Xd& p, const Eigen::Matrix3Xd& q, const Eigen::VectorXd& m,
              const std::vector<int>& nodes, int D) {
  double mass = 0;
  Vec3 p_mean = Vec3::Zero(), q_mean = Vec3::Zero();
  for (const int i : nodes) mass += m[i];
  for (const int i : nodes) {
    p_mean += m[i] / mass * p.col(i);
    q_mean += m[i] / mass * q.col(i);
  }
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  for (const int i : nodes) H += m[i] / mass * (q.col(i) - q_mean) * (p.col(i) - p_mean).transpose();
  if (D == 2) H(2, 2) = 2 * H.norm() + 1;  // turns about z only
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  const Eigen::Matrix3d R = svd.matrixU() * Vec3(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
  double largest = 0;
  for (const int i : nodes) largest = std::max(largest, (q.col(i) - q_mean - R * (p.col(i) - p_mean)).norm());
  return largest;
}

}  // namespace

double shape_distance(const System& system, const Eigen::VectorXd& x, const Eigen::VectorXd& x_other) {
  const System::Parts& parts = system.parts();
  double largest = 0;
  for (std::size_t b = 0; b < parts.ranges.size(); ++b) {
    const BodyRange& range = parts.ranges[b];
    const Eigen::Matrix3Xd p = positions(x_other, range, parts.D), q = positions(x, range, parts.D);
    const std::vector<int> root = connected_parts(*range.mesh);
    std::vector<std::vector<int>> nodes(root.size());
    for (std::size_t i = 0; i < root.size(); ++i) nodes[root[i]].push_back(static_cast<int>(i));
    for (const std::vector<int>& part : nodes)
      if (!part.empty()) largest = std::max(largest, misfit(p, q, parts.masses[b].nodal(), part, parts.D) / range.size);
  }
  return largest;
}

namespace {

// Time in which a wave of stretch runs through the largest body, over h: what a step should resolve [steps].
double steps_per_wave(const System& system) {
  const System::Parts& parts = system.parts();
  double mass = 0, size = 0;
  for (const Mass& m : parts.masses) mass += m.total();
  for (const BodyRange& range : parts.ranges) size = std::max(size, range.size);
  return size * std::sqrt(mass / parts.energy_scale) / parts.h();
}

// Tells from the shapes at every tenth step whether they still change.
class Rest {
 public:
  Rest(const System& system, const State& state) : system_(system), x_(state.x), per_wave_(steps_per_wave(system)) {}

  void look(const State& state) {
    if (state.step % every != 0) return;
    moved_ = shape_distance(system_, state.x, x_) / every * std::max(1.0, per_wave_);
    x_ = state.x;
    quiet_ = moved_ < 1e-9 ? quiet_ + 1 : 0;
  }
  bool settled() const { return moved_ < 1e-5; }
  bool dead() const { return quiet_ >= 3; }

 private:
  static constexpr int every = 10;
  const System& system_;
  Eigen::VectorXd x_;
  double per_wave_;
  double moved_ = 1;  // in the time of a wave or of a step, whichever is longer [body sizes]
  int quiet_ = 0;
};

std::string failure_text(const System& system, const StepReport& report) {
  std::ostringstream text;
  text << "step " << report.step << ", t = " << system.time(report.step) << " s";
  if (report.min_J_element >= 0) text << ", element " << report.min_J_element;
  text << ": " << report.failure;
  return text.str();
}

void add(const StepReport& report, Recovery& r) {
  r.min_J = r.steps == 0 ? report.min_J : std::min(r.min_J, report.min_J);
  r.inverted = report.inverted;
  ++r.steps;
  r.splits += report.splits;
  r.untangled += report.untangled;
  r.newton += report.newton;
  r.linear += report.linear;
  if (report.converged) return;
  if (r.not_converged++ == 0) r.reason = report.reason;
}

}  // namespace

Recovery recover(const System& system, std::int64_t steps, bool loaded, const std::function<bool()>& interrupted) {
  constexpr double near = 1e-4;
  const auto stepper = make_stepper(system, 1);
  State state = system.initial_state();
  Rest rest(system, state);
  Recovery r;
  while (state.step < steps && !rest.dead() && !interrupted()) {
    const StepReport report = stepper->step(state);
    if (!report.failure.empty()) {
      r.failure = failure_text(system, report);
      break;
    }
    add(report, r);
    rest.look(state);
  }
  r.distance = shape_distance(system, state.x, system.parts().X);
  if (!r.failure.empty())
    r.verdict = Verdict::stopped;
  else if (!rest.settled())
    r.verdict = Verdict::not_settled;
  else if (loaded)
    r.verdict = Verdict::at_rest_loaded;
  else
    r.verdict = r.distance <= near ? Verdict::recovered : Verdict::other_equilibrium;
  return r;
}

}  // namespace sim
