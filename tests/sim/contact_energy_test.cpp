// Impacts give no energy, whatever the scheme.
#include "sim/time/energy_limit.h"
#include "tests/sim/contact_support.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

double total_energy(const test::Stepped& run) {
  const Measures m = run.system.measure(run.state);
  return m.kinetic + m.elastic + m.potential;
}

// The largest rise of the energy above the start's.
double largest_gain(const Scene& scene, int steps) {
  test::Stepped run(scene);
  const double start = total_energy(run);
  double gain = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < steps; ++k) {
    run.steps(1);
    gain = std::max(gain, total_energy(run) - start);
  }
  return gain;
}

constexpr const char* without_gain[] = {"backward-euler", "bdf2", "trapezoidal", "tr-bdf2"};
constexpr double noise = 1e-8;  // of the iteration's tolerance, in shares of an energy

Scene dropped_box(const std::string& scheme, int substeps, double degrees) {
  Scene scene;
  scene.bodies = {test::box_body("box", {0.4, 0.4, 0.4}, 2, {0, 0.5, 0})};
  rotate(scene.bodies[0].mesh, {0, 0, 1}, degrees);
  scene.obstacles = {{Plane{{0, 0, 0}, {0, 1, 0}}, 0}};
  scene.time.integrator = scheme;
  scene.time.substeps = substeps;
  return scene;
}

// With the force of a barrier counted again at the next step's start, trapezoidal gains 1.5 and 18.7 times the energy
// of the drop, and tr-bdf2 0.4 times.
TEST(ContactEnergy, NoneIsGainedWhereABoxIsDroppedOnAPlane) {
  const double fall = 1000 * 0.4 * 0.4 * 0.4 * 9.81 * 0.5;  // J, m g times the drop
  for (const char* scheme : without_gain)
    for (const int substeps : {1, 2, 8})
      for (const double degrees : {0.0, 10.0})
        EXPECT_LE(largest_gain(dropped_box(scheme, substeps, degrees), 45 * substeps) / fall, noise)
            << scheme << " h = 1/" << 60 * substeps << ", turned by " << degrees;
}

// Two pieces of rubber in a hurry: 40 m/s is four times the speed of their waves. What no step resolves, trapezoidal
// makes energy of without end, and the second stage of sdirk2, which goes on with the velocity of the first, up to a
// fifth (in the drop above at h = 1/120 s, more than there was).
TEST(ContactEnergy, NoneIsGainedWhereABlockIsThrownAtASphere) {
  for (const char* scheme : {"backward-euler", "bdf2", "trapezoidal", "tr-bdf2", "sdirk2"}) {
    Scene scene;
    scene.world.gravity.setZero();
    scene.bodies = {test::box_body("block", {1, 0.5, 0.5}, 4, {0, 0.5, 0})};
    scene.bodies[0].materials[0].young = 1e5;
    scene.bodies[0].velocity = {0, -40, 0};
    scene.obstacles = {{Sphere{{0.6, -0.5, 0.2}, 0.4}, 0}};
    scene.time.integrator = scheme;
    test::Stepped run(scene);
    const double start = total_energy(run);
    double gain = -start;
    int braked = 0;
    for (int k = 0; k < 120; ++k) {
      run.steps(1);
      braked += run.last.braked;
      gain = std::max(gain, total_energy(run) - start);
    }
    std::printf("%s gains %.1e of its energy, %d steps braked\n", scheme, gain / start, braked);
    EXPECT_LE(gain / start, 1e-3) << scheme;
    if (std::string(scheme) == "trapezoidal") {
      EXPECT_GT(braked, 0);
    }
  }
  EXPECT_LE(largest_gain(dropped_box("sdirk2", 2, 0), 90) / (1000 * 0.4 * 0.4 * 0.4 * 9.81 * 0.5), 1e-3);
}

// What backward Euler lost in an impact does not come back: two blocks that meet off their middles at 100 m/s got up to
// half of it in a step, as they had had it once.
TEST(ContactEnergy, WhatAnImpactTookStaysTaken) {
  for (const char* scheme : {"trapezoidal", "tr-bdf2"}) {
    Scene scene;
    scene.world.gravity.setZero();
    scene.bodies = {test::box_body("a", {0.8, 0.5, 0.5}, 3, {-1, 0, 0}, 1e7),
                    test::box_body("b", {0.8, 0.5, 0.5}, 3, {1, 0.2, 0.1}, 1e7)};
    scene.bodies[0].velocity = {50, 0, 0};
    scene.bodies[1].velocity = {-50, 0, 0};
    scene.contacts = {Contact{}};
    scene.time.integrator = scheme;
    scene.time.fps = 120;
    test::Stepped run(scene);
    double before = total_energy(run), rise = 0;
    for (int k = 0; k < 60; ++k) {
      run.steps(1);
      rise = std::max(rise, total_energy(run) / before - 1);
      before = total_energy(run);
    }
    std::printf("%s: rises by %.1e in a step at most\n", scheme, rise);
    EXPECT_LT(rise, 0.02) << scheme;
  }
}

// Where backward Euler gains as well, the last step counts as far as there is energy for it.
TEST(ContactEnergy, ABrakedStepKeepsTheMomentum) {
  const System system(dropped_box("backward-euler", 1, 0));
  const Model& model = parts_of(system).model;
  TangentOperator tangent(model, 1);
  EnergyLimit limit(model, tangent);
  const State begin = system.initial_state();
  const auto energy = [&](const State& at) {
    const Measures m = system.measure(at);
    return m.kinetic + m.elastic + m.potential;
  };
  State next = begin;
  for (Eigen::Index i = 0; i < next.v.size(); ++i) next.v[i] = std::sin(1.3 * static_cast<double>(i));
  next.x += 1e-3 * next.v;
  for (Eigen::Index i = 1; i < next.x.size(); i += 3) next.x[i] -= 0.01;  // there is something to spend
  ASSERT_TRUE(limit.gains(begin, 0, next, 0));
  const Vec3 p_begin = system.measure(begin).p, p_next = system.measure(next).p;
  limit.brake(begin, 0, next, 0);
  EXPECT_NEAR(energy(next), energy(begin), 1e-9 * system.measure(next).kinetic);
  // Of what the step did, the same share is left in every direction.
  const Vec3 p = system.measure(next).p;
  const double share = (p - p_begin).norm() / (p_next - p_begin).norm();
  EXPECT_GT(share, 0.01);
  EXPECT_LT((p - p_begin - share * (p_next - p_begin)).norm(), 1e-9 * p_next.norm());
}

// Two equal bars of 1 m in the plane, without lateral contraction: one hits the other, at rest, with 1 m/s.
Scene bars(const std::string& scheme, int fps) {
  Scene scene;
  scene.dimension = 2;
  scene.world.gravity = {0, 0, 0};
  for (const char* name : {"first", "second"}) {
    Body body;
    body.name = name;
    body.mesh = generate_rectangle({1, 0.1}, {40, 1}, {1, 1}, ElementKind::quad4);
    body.materials = {MaterialSpec{"linear", 1e6, 0, 1000, ""}};
    scene.bodies.push_back(body);
  }
  translate(scene.bodies[1].mesh, {1.055, 0, 0});
  scene.bodies[0].velocity = {1, 0, 0};
  scene.contacts = {Contact{{}, 0, 1e-4, {}, {}}};
  scene.time.integrator = scheme;
  scene.time.fps = fps;
  scene.solver.tolerance = 1e-7;
  return scene;
}

// m/s along x: the mean over a body of equal masses along it.
double speed_of(const test::Stepped& run, int body) {
  const Model& model = parts_of(run.system).model;
  const BodyRange& range = model.ranges[body];
  Eigen::VectorXd momentum = Eigen::VectorXd::Zero(model.dofs());
  for (const Mass& mass : model.masses) mass.add_product(1, run.state.v, momentum, model.D);
  double p = 0;
  for (int i = 0; i < range.node_count; ++i) p += momentum[model.D * (range.first_node + i)];
  return p / model.masses[body].total();
}

struct Impact {
  double contact = 0;  // s, in which they push by more than a twentieth of what bars without end would
  double kept = 0;     // m/s, of the first
  double gain = 0;     // of energy, relative to the start's
  double drift = 0;    // of momentum, relative to the start's
};
Impact impact(const std::string& scheme, int fps) {
  test::Stepped run(bars(scheme, fps));
  const double push = 0.1 * std::sqrt(1e6 * 1000) / 2;  // N: area times sqrt(E rho) v/2
  const double start = total_energy(run), p = run.system.measure(run.state).p.x();
  Impact it;
  for (int k = 0; k < fps / 6; ++k) {
    run.steps(1);
    it.contact += run.system.contacts(run.state)[0].force.norm() > 0.05 * push ? 1.0 / fps : 0;
    it.gain = std::max(it.gain, total_energy(run) / start - 1);
  }
  it.kept = speed_of(run, 0);
  it.drift = std::abs(run.system.measure(run.state).p.x() / p - 1);
  return it;
}

// Elastic bars exchange their velocities, after a contact of 2 L/c = 63.2 ms. What the first keeps is what the scheme
// took: about the square root of h for backward Euler.
TEST(ContactEnergy, BarsExchangeTheirVelocities) {
  struct Row {
    const char* scheme;
    int fps;
    double kept;
  };
  for (const auto& [scheme, fps, kept] : {Row{"backward-euler", 60, 0.37},
                                          {"backward-euler", 240, 0.20},
                                          {"backward-euler", 1000, 0.10},
                                          Row{"bdf2", 60, 0.16},
                                          {"bdf2", 240, 0.08},
                                          {"bdf2", 1000, 0.03},
                                          Row{"trapezoidal", 60, 0.14},
                                          {"trapezoidal", 480, 0.03},
                                          Row{"tr-bdf2", 60, 0.12},
                                          {"tr-bdf2", 480, 0.02}}) {
    const Impact it = impact(scheme, fps);
    std::printf("%s at h = 1/%d s: %.4f s, keeps %.3f m/s, energy %+.1e, momentum %.1e\n", scheme, fps, it.contact,
                it.kept, it.gain, it.drift);
    // To a step, and to what a wave is told apart by 40 cells.
    EXPECT_NEAR(it.contact, 2 / std::sqrt(1e6 / 1000), std::max(1.01 / fps, 2e-3)) << scheme << " h = 1/" << fps;
    EXPECT_NEAR(it.kept, kept, 0.02) << scheme << " h = 1/" << fps;
    EXPECT_LE(it.gain, noise) << scheme << " h = 1/" << fps;
    EXPECT_LT(it.drift, 1e-9) << scheme << " h = 1/" << fps;
  }
}

// Two plates in the plane, pressed together by nothing but their speed, within a barrier as wide as they are: smooth.
// What keeps impacts from giving energy costs trapezoidal and tr-bdf2 an order, in the barrier's part only.
TEST(ContactEnergy, OrderInASmoothContact) {
  const auto order = [](const char* scheme) {
    const auto after = [&](int substeps) {
      Scene scene = bars(scheme, 30);
      for (Body& body : scene.bodies) body.mesh = generate_rectangle({1, 1}, {2, 2}, {1, 1}, ElementKind::tri3);
      translate(scene.bodies[1].mesh, {1.5, 0.1, 0});
      for (Body& body : scene.bodies) body.materials[0] = {"linear", 2e4, 0.3, 1000, ""};
      scene.contacts = {Contact{{}, 0, 1.0, 1e4, {}}};
      scene.time.substeps = substeps;
      scene.solver.tolerance = 1e-11;
      test::Stepped run(scene);
      run.steps(8 * substeps);
      Eigen::VectorXd both(2 * run.state.x.size());
      both << run.state.x, run.state.v;
      return both;
    };
    const Eigen::VectorXd a = after(16), b = after(32), c = after(64);
    return std::log2((a - b).norm() / (b - c).norm());
  };
  for (const auto& [scheme, expected] :
       {std::pair{"backward-euler", 1}, {"trapezoidal", 1}, {"tr-bdf2", 1}, {"bdf2", 2}, {"sdirk2", 2}})
    EXPECT_NEAR(order(scheme), expected, 0.2) << scheme;
}

}  // namespace
}  // namespace sim
