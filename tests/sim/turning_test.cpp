// Moves by which bodies turn.
#include "sim/solve/turning.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/sim/contact_support.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

Scene spinning(double young, int fps, int dimension = 3) {
  Scene scene;
  scene.dimension = dimension;
  scene.bodies = {test::box_body("box", {1, 0.6, 0.8}, 2, {0, 0.7, 0}, young)};
  scene.bodies[0].spin = Spin{Vec3(0.3, 1, 0.2).normalized(), 8};
  if (dimension == 2) {
    scene.bodies[0].mesh = generate_rectangle({1, 0.6}, {2, 2}, {1, 1}, ElementKind::tri3);
    translate(scene.bodies[0].mesh, {0, 0.7, 0});
    scene.bodies[0].spin.axis = {0, 0, 1};
  }
  scene.time.fps = fps;
  return scene;
}

// What turns along straight ways keeps its shape, whatever the angle, and else the move differs by its square only.
TEST(Turning, KeepsTheShapeOfWhatTurns) {
  for (const int D : {2, 3}) {
    const System system(spinning(1e5, 60, D));
    const Model& model = parts_of(system).model;
    const Eigen::VectorXd free = Eigen::VectorXd::Ones(model.dofs());
    Eigen::VectorXd dx = model.X, turned;
    for (const double angle : {0.01, 1.0, 30.0}) {
      const Vec3 w = angle * (D == 2 ? Vec3(0, 0, 1) : Vec3(0.6, 0, 0.8));
      for (int i = 0; i < model.body_nodes; ++i) {
        Vec3 x = Vec3::Zero();
        x.head(D) = model.X.segment(D * i, D);
        dx.segment(D * i, D) = (Vec3(1, 2, 0) + w.cross(x)).head(D);
      }
      ASSERT_TRUE(turn_along(model, free, 1e-3, model.X, dx, turned));
      for (int i = 1; i < model.body_nodes; ++i) {
        const Eigen::VectorXd before = model.X.segment(D * i, D) - model.X.head(D);
        EXPECT_NEAR((before + turned.segment(D * i, D) - turned.head(D)).norm(), before.norm(), 1e-12);
      }
    }
    dx = test::random_vector(model.dofs(), 1, 4);
    const auto difference = [&](double e) {
      const Eigen::VectorXd way = e * dx;
      EXPECT_TRUE(turn_along(model, free, 0, model.X, way, turned));
      return (turned - way).norm();
    };
    EXPECT_NEAR(difference(1e-3) / difference(5e-4), 4, 0.05);
    EXPECT_FALSE(turn_along(model, Eigen::VectorXd::Zero(model.dofs()), 0, model.X, dx, turned));
  }
}

// Stiff bodies that turn by radians in a step, in the air and on the ground: up to 300 iterations a step along lines,
// 40 at first and 10 then by turning.
TEST(Turning, StiffBodiesTurnInFewIterations) {
  for (const bool ground : {false, true})
    for (const int fps : {7, 1}) {
      Scene scene = spinning(1e9, fps);
      if (ground) scene.obstacles = {Obstacle{Plane{{0, 0, 0}, {0, 1, 0}}}};
      test::Stepped run(scene);
      run.steps(20);
      std::printf("h = 1/%d s%s: %d iterations in 20 steps, %d at most\n", fps, ground ? ", ground" : "", run.newton,
                  run.most_newton);
      EXPECT_LT(run.newton, 300);
      EXPECT_LT(run.most_newton, 80);
    }
}

}  // namespace
}  // namespace sim
