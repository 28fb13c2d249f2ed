// A scene that is stepped: for the tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim/scenes.h"

namespace sim::test {

// The cantilever of the design, 4 x 1 x 1 m, n cells across; clamped at x = 0, gravity along -z.
inline Scene beam(const char* element, int n, double young = 1e6, double poisson = 0.45) {
  Scene scene;
  Body body;
  body.name = "beam";
  body.mesh = generate_box({4, 1, 1}, {4 * n, n, n}, {1, 1, 1}, find_element(element)->kind);
  body.materials = {MaterialSpec{"stable-neo-hookean", young, poisson, 1000, ""}};
  body.pins = {Pin{Box{{-1e-6, -1, -1}, {1e-6, 2, 2}}, "xyz", {}, {}}};
  scene.world.gravity = {0, 0, -9.81};
  scene.probes = {{"tip", "beam", {4, 0.5, 0.5}}};
  scene.bodies = {body};
  return scene;
}

// A plate in the plane, pulled upwards at its right edge by a load that rises smoothly.
inline Scene plate(const std::string& integrator, int substeps) {
  Scene scene;
  scene.dimension = 2;
  Body body;
  body.name = "plate";
  body.mesh = generate_rectangle({2, 1}, {4, 2}, {1, 1}, ElementKind::tri3);
  body.materials = {MaterialSpec{"stable-neo-hookean", 2e4, 0.3, 1000, ""}};
  body.pins = {Pin{InGroup{"left"}, "xy", {}, {}}};
  body.loads.tractions = {Traction{InGroup{"right"}, {0, 1000, 0}, 0.5}};
  scene.bodies = {body};
  scene.world.gravity = {0, 0, 0};
  scene.probes = {{"tip", "plate", {2, 0.5, 0}}};
  scene.time.integrator = integrator;
  scene.time.fps = 30;
  scene.time.substeps = substeps;
  scene.solver.tolerance = 1e-11;
  return scene;
}

// 2 x 1 x 1 m of soft rubber that is damped well enough to come to rest within the run.
inline Scene block(const std::string& material, const std::string& scheme, const std::string& start,
                   std::uint64_t seed) {
  Scene scene;
  Body body;
  body.name = "block";
  body.mesh = generate_box({2, 1, 1}, {4, 2, 2}, {1, 1, 1}, ElementKind::tet4);
  body.materials = {MaterialSpec{material, 1e5, 0.45, 1000, ""}};
  body.damping.alpha = 10;
  body.start.shape = start;
  scene.world.gravity.setZero();
  scene.time.integrator = scheme;
  scene.bodies = {body};
  scene.seed = seed;
  return scene;
}

struct Stepped {
  System system;
  State state;
  std::unique_ptr<Stepper> stepper;
  StepReport last;
  int newton = 0, most_newton = 0;  // iterations: of all steps, of the one that took most

  explicit Stepped(const Scene& scene, int threads = 1)
      : system(scene, threads), state(system.initial_state()), stepper(make_stepper(system, threads)) {}

  void steps(int count) {
    for (int k = 0; k < count; ++k) {
      last = stepper->step(state);
      newton += last.newton;
      most_newton = std::max(most_newton, last.newton);
      ASSERT_EQ(last.failure, "") << "step " << last.step;
      ASSERT_TRUE(last.converged) << "step " << last.step << ", increment " << last.increment;
    }
  }
  // In how many parts a step was taken at most, over so many frames.
  std::int64_t most_parts(int frames) {
    std::int64_t most = 0;
    for (int k = 0; k < frames * system.steps_per_frame(); ++k) {
      steps(1);
      most = std::max(most, state.parts);
    }
    return most;
  }
  double energy() const {  // kinetic and elastic, J
    const Measures now = system.measure(state);
    return now.kinetic + now.elastic;
  }
  Vec3 tip() const { return system.probe_displacement(state, 0); }
};

}  // namespace sim::test
