// Spheres and discs against faces and edges that are larger than they are: nothing comes through between nodes.
#include <gtest/gtest.h>

#include "sim/build/parts.h"
#include "sim/contact/approach.h"
#include "tests/sim/contact_support.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

// A sheet of rubber of 1 m in cells of 0.5 m, or in the plane a rope of 1 m in edges of 0.25 m, both at y = 0.
Body coarse(int D) {
  Body body;
  body.name = D == 2 ? "rope" : "sheet";
  body.materials = {MaterialSpec{"stable-neo-hookean", 1e5, 0.3, 500, ""}};
  body.damping.beta = 0.003;
  if (D == 2) {
    body.mesh = generate_rectangle({1, 0.02}, {4, 1}, {1, 1}, ElementKind::tri3);
    translate(body.mesh, {-0.5, 0, 0});
    return body;
  }
  body.mesh = generate_sheet({1, 1}, {2, 2}, {1, 1}, ElementKind::tri3);
  rotate(body.mesh, {1, 0, 0}, 90);
  translate(body.mesh, {-0.5, 0, -0.5});
  body.thickness = 0.01;
  return body;
}

Scene over_a_ball(int D, const Vec3& centre, double radius) {
  Scene scene;
  scene.dimension = D;
  scene.bodies = {coarse(D)};
  Obstacle ball;
  ball.shape = Sphere{centre, radius};
  ball.friction = 0.4;
  scene.obstacles = {ball};
  return scene;
}

// Below the middle of a face, below an edge, below a node; in the plane below an edge and a node.
const Vec3 below[] = {{0.1, -0.09, 0.23}, {0.24, -0.09, 0.0}, {0, -0.09, 0}};

// A ball of less than a fifth of a face, wherever it is met. Without faces it came through at the first two places.
TEST(SphereObstacle, SmallOnesHoldWhatIsCoarse) {
  for (const int D : {2, 3})
    for (Vec3 centre : below) {
      if (D == 2) centre.z() = 0;
      const Scene scene = over_a_ball(D, centre, 0.05);
      test::Stepped run(scene);
      for (int k = 0; k < 30; ++k) {
        run.last = run.stepper->step(run.state);
        ASSERT_EQ(run.last.failure, "");
        ASSERT_EQ(test::count_entered(scene, run.state.x), 0) << D << "D, step " << k;
      }
      const double fallen = -9.81 / 2 * 0.25;
      double middle = 0;
      for (int node = 0; node < run.system.bodies()[0].node_count; ++node)
        middle += run.state.x[static_cast<Eigen::Index>(node) * D + 1] / run.system.bodies()[0].node_count;
      EXPECT_GT(middle, fallen) << D;
    }
}

// It is what is looked at that counts: without the ball, the same fall goes through where it was.
TEST(SphereObstacle, WhatTheTestLooksForIsFound) {
  Scene scene = over_a_ball(3, below[0], 0.05);
  scene.obstacles[0].release = 0;
  test::Stepped run(scene);
  int entered = 0;
  for (int k = 0; k < 30; ++k) {
    run.steps(1);
    entered += test::count_entered(scene, run.state.x);
  }
  EXPECT_GT(entered, 0);
}

// At 15 m/s a step is 2.5 diameters long; the sheet is thrown at the ball, and the ball at the sheet.
TEST(SphereObstacle, FastOnesDoNotJumpThroughAFace) {
  for (const int D : {2, 3})
    for (const bool ball_moves : {false, true}) {
      Scene scene = over_a_ball(D, {0.1, -0.3, D == 2 ? 0 : 0.23}, 0.05);
      scene.world.gravity.setZero();
      scene.bodies[0].materials[0].young = 1e7;
      if (ball_moves) {
        scene.obstacles[0].motion = {Keyframe{}, Keyframe{}};
        scene.obstacles[0].motion[1].t = 1;
        scene.obstacles[0].motion[1].translate = {0, 15, 0};
      } else {
        scene.bodies[0].velocity = {0, -15, 0};
      }
      test::Stepped run(scene);
      const int first = run.system.bodies()[0].node_count;
      for (int k = 0; k < 4; ++k) {
        run.last = run.stepper->step(run.state);
        ASSERT_EQ(run.last.failure, "");
        ASSERT_EQ(test::count_entered(scene, run.state.x), 0) << D << "D, step " << k;
      }
      // The ball is still on its side: in the plane through it, the body goes over it.
      const double ball = ball_moves ? run.state.x[static_cast<Eigen::Index>(first) * D + 1] : -0.3;
      double over = -1e9;
      for (const test::SurfaceFacet& facet : test::facets_of(scene))
        for (int i = 0; i < D; ++i)
          over = std::max(over, run.state.x[static_cast<Eigen::Index>(facet.nodes[i]) * D + 1]);
      EXPECT_GT(over, ball) << D << "D, " << ball_moves;
    }
}

// Bent upwards away from x = 0 or z = 0, so that an edge or a node there is nearest, not a face beside it.
Eigen::VectorXd bent(const Model& model, double along_x, double along_z) {
  Eigen::VectorXd x = model.X;
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(model.body_nodes) * model.D; i += model.D)
    x[i + 1] += along_x * std::abs(x[i]) + (model.D == 3 ? along_z * std::abs(x[i + 2]) : 0);
  return x;
}

// Force and product against differences of energy and force, with friction; the obstacle's own node stays.
void check_derivatives(const Model& model, const Eigen::VectorXd& x) {
  const Term& term = *model.terms.back();
  const auto store = term.make_store(1);
  const double rate = 60, e = 1e-8;
  const Eigen::VectorXd v = test::random_vector(x.size(), 1e-3, 1);
  const auto random = [&](unsigned seed) {
    Eigen::VectorXd p = test::random_vector(x.size(), 1, seed);
    p.tail(model.D).setZero();
    return p;
  };
  const Eigen::VectorXd p = random(3), none = Eigen::VectorXd::Zero(x.size());
  term.begin_step({x, v, 0, rate}, *store);
  const auto moved = [&](double a, const auto& f) {
    const Eigen::VectorXd y = x + a * p, w = v + a * rate * p;
    return f(Motion{y, w, 0, rate});
  };
  const auto energy = [&](const Motion& m) { return term.energy(m, *store); };
  const auto force = [&](const Motion& m) {
    Eigen::VectorXd f = none;
    term.add_forces(m, *store, f);
    return f;
  };
  const auto product = [&](Definiteness fix, const Eigen::VectorXd& q) {
    Eigen::VectorXd unused = none, y = none;
    moved(0, [&](const Motion& m) { term.linearise(m, fix, *store, unused); });
    term.add_product(*store, 1, q, y);
    return y;
  };
  const Eigen::VectorXd f = moved(0, force), difference = (moved(-e, force) - moved(e, force)) / (2 * e);
  ASSERT_GT(f.norm(), 0);
  EXPECT_NEAR(-f.dot(p), (moved(e, energy) - moved(-e, energy)) / (2 * e), 1e-6 * f.norm() * p.norm());
  EXPECT_LT((product(Definiteness::none, p) - difference).norm(), 1e-5 * difference.norm());
  // Made definite, it is so along any move.
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Eigen::VectorXd q = random(seed), y = product(Definiteness::clamp, q);
    EXPECT_GE(q.dot(y), -1e-9 * y.norm() * q.norm());
  }
}

TEST(SphereObstacle, DerivativesAtFacesEdgesAndNodes) {
  for (const int D : {2, 3})
    for (int feature = 0; feature < 3; ++feature) {
      SCOPED_TRACE(std::to_string(D) + "D, " + std::to_string(feature));
      Vec3 centre = below[feature];
      if (D == 2) centre.z() = 0;
      centre.y() = -0.0502;
      Scene scene = over_a_ball(D, centre, 0.05 - 1e-4);
      scene.obstacles[0].motion = {Keyframe{}};
      const System system(scene);
      const Model& model = parts_of(system).model;
      check_derivatives(model, bent(model, feature == 2 ? 0.3 : 0, feature > 0 ? 0.3 : 0));
    }
}

// The limit is safe and of use: the patch stays outside all the way, and what slides past is not held back.
TEST(SphereObstacle, StepLimitIsSafeAndNotIdle) {
  const Sphere ball{{0.1, -0.2, 0.2}, 0.15}, still{{0, 0, 0}, 0.15};
  for (const int count : {2, 3})
    for (unsigned seed = 0; seed < 200; ++seed) {
      Patch at{count, {}}, move{count, {}};
      const Eigen::VectorXd r = test::random_vector(18, 1, seed);
      for (int i = 0; i < 3; ++i) {
        at.x[i] = r.segment<3>(3 * i);
        move.x[i] = r.segment<3>(9 + 3 * i);
      }
      const double start = gap(ball, at);
      if (start < 1e-3) continue;
      const double limit = std::min(1.0, way_to(ball, still, at, move, 1e-3));
      double least = start;
      for (int k = 0; k <= 200; ++k) {
        Patch on_way = at;
        for (int i = 0; i < count; ++i) on_way.x[i] += limit * k / 200 * move.x[i];
        least = std::min(least, gap(ball, on_way));
      }
      EXPECT_GT(least, 0) << seed;
      if (limit < 1) {
        EXPECT_LT(least, 0.5 * start) << "stops too early: seed " << seed << ", limit " << limit;
      }
    }
}

// A sheet wrapped over a ball much larger than its faces: what is carried is its weight, by friction and pressure.
TEST(SphereObstacle, CarriesTheWeightOfWhatLiesOnIt) {
  Scene scene = over_a_ball(3, {0, -0.601, 0}, 0.6);
  scene.bodies[0].mesh = generate_sheet({1, 1}, {8, 8}, {1, 1}, ElementKind::tri3);
  rotate(scene.bodies[0].mesh, {1, 0, 0}, 90);
  translate(scene.bodies[0].mesh, {-0.5, 0, -0.5});
  scene.bodies[0].damping = {20, 0.003};
  test::Stepped run(scene);
  run.steps(120);
  const Model& model = parts_of(run.system).model;
  Eigen::VectorXd f = Eigen::VectorXd::Zero(model.dofs());
  const Motion now{run.state.x, run.state.v, 2, 0};
  const auto store = model.smooth[0]->make_store(1);
  model.smooth[0]->begin_step(now, *store);
  model.smooth[0]->add_forces(now, *store, f);
  double up = 0;
  for (Eigen::Index i = 1; i < f.size(); i += 3) up += f[i];
  EXPECT_NEAR(up / (500 * 0.01 * 9.81), 1, 0.02);
  EXPECT_EQ(test::count_entered(scene, run.state.x), 0);
}

}  // namespace
}  // namespace sim
