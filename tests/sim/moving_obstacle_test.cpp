// Obstacles of every kind that move: nothing passes them, and what they press is reported where it has no room.
#include "sim/term/obstacle.h"
#include "tests/sim/obstacle_support.h"

namespace sim {
namespace {

using test::highest, test::lowest, test::one_box, test::steps_without_crossing;

// A plate comes down on a box until 0.3 m of it are left, and is taken away: the box stands up again.
TEST(MovingObstacle, PressesABoxToAThirdAndLetsGo) {
  Scene scene = one_box(3);
  scene.bodies[0].materials[0].poisson = 0.2;
  scene.obstacles = {test::surface_obstacle(test::box_mesh({4, 1, 4}, {-1.3, -1, -1.4})),
                     test::surface_obstacle(test::box_mesh({4, 1, 4}, {-1.4, 1.05, -1.3}), {0, -0.75, 0})};
  scene.obstacles[1].release = 1.1;
  test::Stepped run(scene);
  steps_without_crossing(scene, run, 60);
  EXPECT_LT(highest(run.state, run.system.bodies()[0], 3), 0.3);
  EXPECT_GT(lowest(run.state, run.system.bodies()[0], 3), 0);
  run.steps(30);
  EXPECT_GT(highest(run.state, run.system.bodies()[0], 3), 0.8);
  EXPECT_EQ(run.system.contacts(run.state).at(1).pairs, 0);  // with the plate that is gone
}

// The same by planes, and with one of them turning.
TEST(MovingObstacle, PlanesPress) {
  Scene scene = one_box();
  Obstacle floor, press;
  floor.shape = Plane{{0, 0, 0}, {0, 1, 0}};
  press.shape = Plane{{0, 1.1, 0}, {0, -1, 0}};
  press.motion = {Keyframe{}, Keyframe{}};
  press.motion[1].t = 1;
  press.motion[1].translate = {0, -0.5, 0};
  press.motion[1].degrees = 10;
  press.motion[1].centre = {0.5, 1.1, 0.5};
  scene.obstacles = {floor, press};
  test::Stepped run(scene);
  run.steps(60);
  const auto shape = std::get<Plane>(*run.system.obstacle(run.state, 1));
  EXPECT_NEAR(shape.normal.dot(Vec3(0, -1, 0)), std::cos(10 * 3.14159265358979 / 180), 1e-12);
  const BodyRange& body = run.system.bodies()[0];
  for (int node = 0; node < body.node_count; ++node) {
    const Vec3 x = run.state.x.segment<3>(3 * node);
    EXPECT_GT(x.y(), 0);
    EXPECT_GT(shape.normal.dot(x - shape.point), 0);
  }
}

// Faster than a body is large in a step.
TEST(MovingObstacle, FastSphereAndFastSurfacePushABodyAway) {
  for (const bool surface : {false, true}) {
    Scene scene = one_box();
    scene.world.gravity = {0, 0, 0};
    Obstacle ball;
    if (surface) {
      ball = test::surface_obstacle(test::box_mesh({0.5, 2, 2}, {-0.6, -0.3, -0.25}, 1), {40, 0, 0});
    } else {
      ball = test::surface_obstacle(test::box_mesh({1, 1, 1}, {0, 0, 0}), {40, 0, 0});
      ball.shape = Sphere{{-1.5, 0.5, 0.5}, 0.6};
    }
    scene.obstacles = {ball};
    test::Stepped run(scene);
    for (int k = 0; k < 12; ++k) {
      run.last = run.stepper->step(run.state);
      ASSERT_EQ(run.last.failure, "") << "step " << k;
      ASSERT_EQ(test::count_crossings(scene, run.state.x, false), 0) << "step " << k;
    }
    const BodyRange& body = run.system.bodies()[0];
    EXPECT_GT(run.system.measure(run.state).p.x(), 1000) << surface;
    if (surface) continue;
    const auto sphere = std::get<Sphere>(*run.system.obstacle(run.state, 0));
    for (int node = 0; node < body.node_count; ++node)
      EXPECT_GT((run.state.x.segment<3>(3 * node) - sphere.centre).norm(), sphere.radius);
  }
}

// Nothing is left between two that close on each other: the run stops and says who presses what.
TEST(MovingObstacle, WhatHasNoRoomIsReported) {
  for (const bool surface : {true, false}) {
    Scene scene = one_box(1);
    scene.obstacles = {test::surface_obstacle(test::box_mesh({4, 1, 4}, {-1.3, -1, -1.4})),
                       test::surface_obstacle(test::box_mesh({4, 1, 4}, {-1.4, 1.05, -1.3}), {0, -1.2, 0})};
    scene.obstacles[0].name = "table";
    scene.obstacles[1].name = "press";
    if (!surface) {
      scene.obstacles[0].shape = Plane{{0, 0, 0}, {0, 1, 0}};
      scene.obstacles[1].shape = Plane{{0, 1.05, 0}, {0, -1, 0}};
    }
    System system(scene);
    State state = system.initial_state();
    const auto stepper = make_stepper(system, 1);
    StepReport report;
    int k = 0;
    for (; k < 60 && report.failure.empty(); ++k) {
      report = stepper->step(state);
      ASSERT_EQ(test::count_crossings(scene, state.x), 0) << "step " << k;
    }
    EXPECT_GT(k, 30);
    EXPECT_NE(report.failure.find("\"press\" presses \"box\""), std::string::npos) << report.failure;
  }
}

// A belt that runs under a box carries it along.
TEST(MovingObstacle, FrictionCarriesABodyAlong) {
  for (const bool surface : {true, false}) {
    Scene scene = one_box();
    scene.bodies[0].mesh = test::box_mesh({1, 1, 1}, {0, 5e-4, 0}, 2);
    scene.bodies[0].damping.beta = 0.05;
    scene.obstacles = {test::surface_obstacle(test::box_mesh({20, 1, 4}, {-10, -1, -1.4}), {2, 0, 0})};
    if (!surface) scene.obstacles[0].shape = Plane{{0, 0, 0}, {0, 1, 0}};
    scene.obstacles[0].friction = 0.6;
    test::Stepped run(scene);
    run.steps(59);
    const Measures m = run.system.measure(run.state);
    EXPECT_NEAR(m.p.x() / 1000, 2, 0.4) << surface;  // it rocks
  }
}

// Of the term of a plane that turns and moves: what nodes of the obstacle do to the force is in the product as well.
TEST(MovingObstacle, ProductCountsItsOwnNodes) {
  for (const bool sphere : {false, true}) {
    Scene scene = one_box();
    Obstacle obstacle;
    if (sphere)
      obstacle.shape = Sphere{{0.62, -0.4995, 0.81}, 0.509};  // below the inside of a face
    else
      obstacle.shape = Plane{{0.3, 0.0096, 0.1}, {0, 1, 0}};
    obstacle.motion = {Keyframe{}};
    scene.obstacles = {obstacle};
    System system(scene);
    const Model& model = parts_of(system).model;
    const Term& term = *model.terms.back();
    const auto store = term.make_store(1);
    const Eigen::VectorXd x = model.X, p = test::random_vector(x.size(), 1, 3);
    term.begin_step({x, x, 0, 0}, *store);
    const auto force = [&](double e) {
      const Eigen::VectorXd y = x + e * p;
      Eigen::VectorXd f = Eigen::VectorXd::Zero(x.size());
      term.add_forces({y, y, 0, 0}, *store, f);
      return f;
    };
    const double e = 1e-8;
    Eigen::VectorXd f = Eigen::VectorXd::Zero(x.size()), y = f;
    const Eigen::VectorXd difference = (force(-e) - force(e)) / (2 * e);
    EXPECT_GT(difference.norm(), 0);
    term.linearise({x, x, 0, 0}, Definiteness::none, *store, f);
    term.add_product(*store, 1, p, y);
    const Eigen::Index own = 3 * model.body_nodes;
    // Along the normal; that a turning plane also turns the force is left to the next iteration.
    for (Eigen::Index i = 1; i < own; i += 3)
      EXPECT_NEAR(y[i], difference[i], 1e-5 * difference.norm() + (sphere ? 0 : 1e-4 * difference.norm())) << sphere;
  }
}

// How far a node and a plane that turns towards it may go is where they meet.
TEST(MovingObstacle, StepEndsWhereATurningPlaneIsMet) {
  Scene scene = one_box();
  Obstacle obstacle;
  obstacle.shape = Plane{{-0.5, -0.05, 0}, {0, 1, 0}};
  obstacle.motion = {Keyframe{}};
  scene.obstacles = {obstacle};
  System system(scene);
  const Model& model = parts_of(system).model;
  const Term& term = *model.terms.back();
  const auto store = term.make_store(1);
  Eigen::VectorXd dx = Eigen::VectorXd::Zero(model.dofs());
  dx.segment<3>(3 * model.body_nodes + 3) = Vec3(-1, 0, 0);  // the end of its normal: it turns by up to 45 degrees
  const double a = term.largest_step({model.X, model.X, 0, 0}, dx, *store);
  ASSERT_LT(a, 1);
  const auto gap = [&](double share) {
    const Eigen::VectorXd x = model.X + share * dx;
    const auto plane = shape_at(std::get<Plane>(obstacle.shape), model.obstacle_nodes[0], x, 3);
    double least = 1e30;
    for (int node = 0; node < model.body_nodes; ++node)
      least = std::min(least, sim::gap(plane, Patch{1, {x.segment<3>(3 * node)}}));
    return least;
  };
  EXPECT_GT(gap(0.999 * a), 0);
  EXPECT_NEAR(gap(a), 0, 1e-12);
}

// Both of them move, in every implicit scheme; resumed, and with more threads, to the same bits.
TEST(MovingObstacle, SameBitsResumedAndForAnyThreads) {
  for (const auto& [linear, name] : choices<LinearSolverKind>) {
    Scene scene = one_box();
    scene.solver.linear = linear;
    scene.obstacles = {test::surface_obstacle(test::box_mesh({4, 1, 4}, {-1.3, -1, -1.4})),
                       test::surface_obstacle(test::box_mesh({4, 1, 4}, {-1.4, 1.02, -1.3}), {0, -0.6, 0})};
    scene.obstacles[1].friction = 0.3;
    test::Stepped through(scene), two(scene, 2);
    through.steps(10);
    const State saved = through.state;
    through.steps(8);
    two.steps(18);
    test::Stepped resumed(scene);
    resumed.state = saved;
    resumed.steps(8);
    EXPECT_EQ(hash(through.state), hash(resumed.state)) << name;
    EXPECT_EQ(hash(through.state), hash(two.state)) << name;
  }
}

TEST(MovingObstacle, EverySchemeThatKeepsItsPromise) {
  for (const char* integrator : {"backward-euler", "bdf2", "sdirk2", "tr-bdf2", "trapezoidal", "static"}) {
    Scene scene = one_box();
    scene.time.integrator = integrator;
    scene.obstacles = {test::surface_obstacle(test::box_mesh({4, 1, 4}, {-1.3, -1, -1.4})),
                       test::surface_obstacle(test::box_mesh({4, 1, 4}, {-1.4, 1.02, -1.3}), {0, -0.4, 0})};
    scene.obstacles[0].friction = 0.5;
    if (scene.time.integrator == "static") scene.bodies[0].pins = {Pin{Box{{-1, 0, -1}, {2, 0.011, 2}}, "xz", {}, {}}};
    System system(scene);
    State state = system.initial_state();
    const auto stepper = make_stepper(system, 1);
    for (int k = 0; k < 30; ++k) {
      const StepReport report = stepper->step(state);
      ASSERT_EQ(report.failure, "") << integrator << " step " << k;
      ASSERT_EQ(test::count_crossings(scene, state.x), 0) << integrator << " step " << k;
    }
    EXPECT_LT(highest(state, system.bodies()[0], 3), 0.83) << integrator;
  }
}

TEST(MovingObstacle, SchemesThatDoNotLookAreRefused) {
  for (const char* integrator : {"implicit-midpoint", "linearly-implicit", "symplectic-euler", "central-difference"}) {
    Scene scene = one_box();
    scene.time.integrator = integrator;
    scene.obstacles = {test::surface_obstacle(test::box_mesh({1, 1, 1}, {0, -2, 0}))};
    try {
      System system(scene);
      FAIL() << integrator;
    } catch (const InputError& error) {
      EXPECT_EQ(error.key, "time.integrator");
    }
  }
}

}  // namespace
}  // namespace sim
