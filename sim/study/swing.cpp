#include "sim/study/swing.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/build/parts.h"
#include "sim/reduce/at_rest.h"
#include "sim/system.h"

namespace sim {

Scene alone_in_basis(const Scene& scene, std::size_t number) {
  Scene one = scene;
  one.bodies = {scene.bodies[number]};
  one.obstacles.clear();
  one.contacts.clear();
  one.springs.clear();
  one.probes.clear();
  one.time.integrator = "trapezoidal";
  Body& body = one.bodies[0];
  auto vectors = std::make_shared<BasisVectors>(*body.basis->vectors);
  vectors->cubature.reset();
  body.basis->vectors = std::move(vectors);
  for (Traction& load : body.loads.tractions) load.ramp = 0;
  for (Pressure& load : body.loads.pressures) load.ramp = 0;
  for (PointForce& load : body.loads.forces) load.ramp = 0;
  return one;
}

Scene under_weight(Scene alone, int axis, double acceleration) {
  Body& body = alone.bodies[0];
  body.loads = {};
  body.start = {};
  body.velocity.setZero();
  body.spin = {};
  alone.world.gravity = acceleration * Vec3::Unit(axis);
  return alone;
}

Scene swinging(Scene scene, double omega) {
  const double frequency = steps_a_swing * omega / (2 * std::numbers::pi);
  scene.time.integrator = "trapezoidal";
  scene.solver = {};
  scene.time.substeps = scene.time.unit = 1;
  scene.time.fps = static_cast<int>(std::clamp(std::round(frequency), 1.0, 1e6));
  if (frequency < 1) scene.time.unit = static_cast<int>(std::min(std::round(1 / frequency), 1e6));
  return scene;
}

Response response_in_basis(const Scene& alone) {
  const System system(alone);
  const Reduction& reduction = *parts_of(system).reduction;
  const AtRest rest(reduction);
  const int D = system.dimension();
  Response response;
  response.omega = std::sqrt(std::max(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(rest.K).eigenvalues()[0], 0.0));
  response.size = system.bodies()[0].size;
  response.per_axis.resize(D);
  for (int axis = 0; axis < D; ++axis) {
    Eigen::VectorXd along = Eigen::VectorXd::Zero(reduction.lift->dofs());
    for (Eigen::Index i = axis; i < along.size(); i += D) along[i] = 1;
    const Eigen::VectorXd u = rest.displacement(reduction, reduction.mass.transpose() * along);
    response.per_axis[axis] = u.reshaped(D, u.size() / D).colwise().norm().maxCoeff();
  }
  return response;
}

}  // namespace sim
