#include "sim/study/projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/build/parts.h"
#include "sim/solve/mass_product.h"
#include "sim/stepper.h"
#include "sim/study/swing.h"

namespace sim {

namespace {

Scene without_bases(Scene scene) {
  for (Body& body : scene.bodies) body.basis.reset();
  scene.probes.clear();
  scene.solver = {};
  return scene;
}

// So many steps, a column each.
Eigen::MatrixXd stepped(const Scene& scene, int steps, int threads) {
  const System system(scene, threads);
  const Model& model = parts_of(system).model;
  const auto stepper = make_stepper(system, useful_threads(system, threads));
  State state = system.initial_state();
  Eigen::MatrixXd u(model.dofs(), steps);
  for (int k = 0; k < steps; ++k) {
    if (!stepper->step(state).failure.empty()) return u.leftCols(k);
    u.col(k) = state.x - model.X;
  }
  return u;
}

double squared(const Model& model, const Eigen::VectorXd& u) {
  return u.dot(mass_product(model, u));
}

// Displacements as shares of the size of the body that they are of.
Eigen::VectorXd over_size(const Model& model, Eigen::VectorXd d) {
  for (Eigen::Index node = 0; node < model.body_nodes; ++node)
    d.segment(node * model.D, model.D) /= model.node_size[node];
  return d;
}

// What the basis leaves of a displacement.
Eigen::VectorXd left_of(const Reduction& reduction, const Eigen::VectorXd& u) {
  Eigen::VectorXd held;
  reduction.lift->move(reduction.rate_of(u), held);
  return u - held;
}

}  // namespace

Eigen::MatrixXd displacement_at_rest(Scene scene, int threads) {
  scene.time.integrator = "static";
  return stepped(scene, 1, threads);
}

Eigen::MatrixXd rest_of_full(const Scene& scene, int threads) {
  return displacement_at_rest(without_bases(scene), threads);
}

Eigen::MatrixXd swing_of_full(const Scene& scene, int threads) {
  double slowest = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    slowest = std::min(slowest, response_in_basis(alone_in_basis(scene, b)).omega);
  return stepped(swinging(without_bases(scene), slowest), steps_a_swing / 2, threads);
}

std::optional<double> projection_error(const System& reduced, const Eigen::MatrixXd& u) {
  const Parts& parts = parts_of(reduced);
  double left = 0, all = 0;
  for (const auto& state : u.colwise()) {
    left += squared(parts.model, left_of(*parts.reduction, state));
    all += squared(parts.model, state);
  }
  if (!(all > 0)) return {};
  return std::sqrt(left / all);
}

double share_of_size(const System& system, const Eigen::VectorXd& d) {
  const Model& model = parts_of(system).model;
  double mass = 0;
  for (const Mass& body : model.masses) mass += body.total();
  return std::sqrt(squared(model, over_size(model, d)) / mass);
}

Compared compare(const System& reduced, std::span<const std::int64_t> steps, const Eigen::MatrixXd& u, int threads) {
  const Parts& parts = parts_of(reduced);
  const Model& model = parts.model;
  const auto stepper = make_stepper(reduced, useful_threads(reduced, threads));
  State state = reduced.initial_state();
  Compared result;
  Eigen::Array2d sums = {0, 0};  // of the squares: as near as the basis can come, and what its run comes to
  for (std::size_t k = 0; k < steps.size(); ++k) {
    while (state.step < steps[k]) {
      const StepReport report = stepper->step(state);
      if (report.failure.empty()) continue;
      result.failure = failure_text(reduced, report);
      return result;
    }
    const Eigen::VectorXd full = u.col(static_cast<Eigen::Index>(k)), off = state.x - model.X - full;
    sums +=
        Eigen::Array2d(share_of_size(reduced, left_of(*parts.reduction, full)), share_of_size(reduced, off)).square();
    const Eigen::VectorXd shares = over_size(model, off);
    result.most = std::max(result.most, shares.reshaped(model.D, off.size() / model.D).colwise().norm().maxCoeff());
  }
  const Eigen::Array2d means = (sums / static_cast<double>(steps.size())).sqrt();
  result.best = means[0];
  result.made = means[1];
  return result;
}

}  // namespace sim
