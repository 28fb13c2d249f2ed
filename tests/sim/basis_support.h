// Scenes whose bodies move in a basis, and how far they are from others.
#pragma once

#include "sim/solve/tangent_operator.h"
#include "sim/study/basis.h"
#include "tests/sim/stepping.h"

namespace sim::test {

// The beam of tests/data/lecture/reduced.json.
inline Scene plane_cantilever(double young, const std::string& integrator, int nx = 32, int ny = 8) {
  Scene scene;
  scene.dimension = 2;
  Body body;
  body.name = "beam";
  body.mesh = generate_rectangle({4, 1}, {nx, ny}, {1, 1}, ElementKind::tri3);
  body.materials = {MaterialSpec{"stable-neo-hookean", young, 0.3, 1000, ""}};
  body.pins = {Pin{InGroup{"left"}, "xy", {}, {}}};
  scene.bodies = {body};
  scene.probes = {{"tip", "beam", {4, 0.5, 0}}};
  scene.time.integrator = integrator;
  scene.solver.tolerance = 1e-8;
  return scene;
}

inline Scene reduced(Scene scene, BasisKind kind, int count, double cubature = 0, int threads = 1) {
  for (Body& body : scene.bodies) body.basis = Basis{kind, count, cubature, {}, {}};
  return with_bases_made(std::move(scene), threads);
}

// The frames of so many steps; the first one is the start.
inline Eigen::MatrixXd frames(const Scene& scene, int steps, int threads = 1) {
  Stepped run(scene, threads);
  Eigen::MatrixXd x(run.state.x.size(), steps + 1);
  x.col(0) = run.state.x;
  for (int k = 1; k <= steps; ++k) {
    run.steps(1);
    x.col(k) = run.state.x;
  }
  return x;
}

// sqrt(sum m |x - y|^2 / sum m) / size for each frame, then the root of the mean square. [mathematics.md 9]
inline double rms(const Scene& scene, const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) {
  const System system(scene);
  const Model& model = parts_of(system).model;
  double sum = 0;
  for (Eigen::Index k = 0; k < x.cols(); ++k) {
    const Eigen::VectorXd d = x.col(k) - y.col(k);
    Eigen::VectorXd Md = Eigen::VectorXd::Zero(d.size());
    model.masses[0].add_product(1, d, Md, model.D);
    sum += d.dot(Md) / model.masses[0].total();
  }
  return std::sqrt(sum / static_cast<double>(x.cols())) / model.ranges[0].size;
}

inline Scene with_snapshots(Scene scene, const Eigen::MatrixXd& x, int count) {
  const auto u = std::make_shared<const Eigen::MatrixXd>(x.colwise() - x.col(0));
  scene.bodies[0].basis = Basis{BasisKind::snapshots, count, 0, u, {}};
  return with_bases_made(std::move(scene));
}

// Central differences of U(c) are its forces, those of the forces its stiffness, at coordinates c inside a stage, where
// v = (c - c*)/(g h); c* = 0 here.
inline void expect_derivatives(const Model& model, const Eigen::VectorXd& c) {
  constexpr double rate = 60, t = 0.03, e = 1e-6;
  const Eigen::Index r = model.dofs();
  TangentOperator tangent(model, 1);
  tangent.free().setOnes();
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(r);
  tangent.begin_step({still, still, 0, 0});
  Eigen::VectorXd f(r), g(r), h(r), p(r), Kp(r);
  const Eigen::VectorXd v = rate * c;
  tangent.linearise({c, v, t, rate}, 0, Definiteness::none, f);
  for (Eigen::Index k = 0; k < r; ++k) {
    const Eigen::VectorXd d = e * model.node_size[k] * Eigen::VectorXd::Unit(r, k);
    const Eigen::VectorXd above = c + d, below = c - d, va = rate * above, vb = rate * below;
    const Motion up{above, va, t, rate}, down{below, vb, t, rate};
    EXPECT_NEAR(-f[k], (tangent.energy(up) - tangent.energy(down)) / (2 * d[k]), 1e-6 * f.norm()) << k;
    p.setUnit(r, k);
    tangent.multiply(p, Kp);
    tangent.forces(up, g);
    tangent.forces(down, h);
    EXPECT_LT((Kp + (g - h) / (2 * d[k])).norm(), 1e-6 * Kp.norm()) << k;
  }
}

// A small block in space with everything that acts on one: a traction that rises, a pressure, a force, damping, a
// spring, a region of other material.
inline Scene loaded_block(const std::string& integrator) {
  Scene scene;
  Body body;
  body.name = "block";
  body.mesh = generate_box({2, 1, 1}, {4, 2, 2}, {1, 1, 1}, ElementKind::tet4);
  disturb(body.mesh, 0.08, 3);
  Group half{"half", {}, {}, {}, 3};
  for (int e = 0; e < body.mesh.element_count() / 2; ++e) half.elements.push_back(e);
  body.mesh.groups.push_back(half);
  body.materials = {MaterialSpec{"stable-neo-hookean", 1e5, 0.4, 1000, ""},
                    MaterialSpec{"corotated", 3e5, 0.3, 2000, "half"}};
  body.pins = {Pin{Box{{-1e-6, -1, -1}, {1e-6, 2, 2}}, "xyz", {}, {}}};
  body.loads.tractions = {Traction{Box{{2 - 1e-6, -1, -1}, {3, 2, 2}}, {0, 500, 100}, 0.1}};
  body.loads.pressures = {Pressure{Region(Box{{-1, -1, 1 - 1e-6}, {3, 2, 2}}), 400, 0.05}};
  body.loads.forces = {PointForce{{1.9, 0.4, 0.3}, {20, -30, 10}, 0}};
  body.damping = {0.5, 0.01};
  scene.bodies = {body};
  scene.springs = {Spring{"block", {1.8, 0.2, 0.4}, {2, 0.5, 0.5}, 300}};
  scene.time.integrator = integrator;
  scene.solver.tolerance = 1e-9;
  return scene;
}

}  // namespace sim::test
