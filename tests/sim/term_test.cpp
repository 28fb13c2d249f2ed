// Terms other than the elastic one: derivatives against differences, and what they do to a body.
#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <typeindex>

#include "sim/build/parts.h"
#include "sim/solve/tangent_operator.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

// A small beam with every term there is: nodes near the plane below and the sphere above it.
Scene everything() {
  Scene scene = test::beam("tet4", 1);
  Body& body = scene.bodies[0];
  body.pins.clear();
  body.damping = {0.7, 2e-3};
  body.loads.tractions = {Traction{InGroup{"right"}, {300, -200, 500}, 0.0}};
  body.loads.pressures = {Pressure{InGroup{"top"}, 800, 0.0}};
  body.loads.forces = {PointForce{{3.9, 0.4, 0.3}, {20, -30, 10}, 0.0}};
  body.untangle = 2;
  Obstacle floor{Plane{{0, 0, -0.002}, {0, 0, 1}}, 0.4}, ball{Sphere{{2, 0, 3.002}, 2}, 0.3};
  scene.obstacles = {floor, ball};
  scene.springs = {Spring{"beam", {2, 0.5, 0.5}, {2, 1, 1}, 5000}};
  return scene;
}

class Terms : public ::testing::Test {
 protected:
  Terms() : system_(everything()), parts_(parts_of(system_).model), tangent_(parts_, 1) {
    x_ = parts_.X + test::random_vector(parts_.dofs(), 5e-4, 1);
    fold_the_corner();
    v_ = test::random_vector(parts_.dofs(), 0.01, 2);
    p_ = test::random_vector(parts_.dofs(), 1, 3);
    tangent_.begin_step({x_, v_, 0, 0});
  }
  // The corner (4, 1, 1) into the beam, which turns its elements inside out: what untangles has something to do.
  void fold_the_corner() {
    for (Eigen::Index i = 0; i < x_.size(); i += 3)
      if (parts_.X.segment<3>(i) == Vec3(4, 1, 1)) x_[i] -= 1.5;
  }
  // Inside a stage v moves with x: v = v_0 + (x - x_0) rate.
  template <class F>
  auto moved(double e, const F& f) {
    const Eigen::VectorXd x = x_ + e * p_, v = v_ + rate_ * e * p_;
    return f(Motion{x, v, 0.2, rate_});
  }

  System system_;
  const Model& parts_;
  TangentOperator tangent_;
  Eigen::VectorXd x_, v_, p_;
  double rate_ = 60;
};

TEST_F(Terms, ForceIsMinusTheGradient) {
  for (std::size_t k = 0; k < parts_.terms.size(); ++k) {
    const Term& term = *parts_.terms[k];
    Term::Store& store = *tangent_.stores()[k];
    const double e = 1e-7;
    const auto energy = [&](const Motion& m) { return term.energy(m, store); };
    Eigen::VectorXd f = Eigen::VectorXd::Zero(x_.size());
    moved(0, [&](const Motion& m) { term.add_forces(m, store, f); });
    EXPECT_GT(f.norm(), 0) << term.info().name;
    const double difference = (moved(e, energy) - moved(-e, energy)) / (2 * e);
    EXPECT_NEAR(-f.dot(p_), difference, 2e-6 * f.norm() * p_.norm()) << term.info().name;
  }
}

TEST_F(Terms, ProductDiagonalAndMatrixAreTheDerivativeOfTheForce) {
  for (std::size_t k = 0; k < parts_.terms.size(); ++k) {
    const Term& term = *parts_.terms[k];
    Term::Store& store = *tangent_.stores()[k];
    const auto force = [&](const Motion& m) {
      Eigen::VectorXd f = Eigen::VectorXd::Zero(x_.size());
      term.add_forces(m, store, f);
      return f;
    };
    const double e = 1e-7;
    const Eigen::VectorXd difference = (moved(-e, force) - moved(e, force)) / (2 * e);
    Eigen::VectorXd f = Eigen::VectorXd::Zero(x_.size()), y = f, diagonal = f, column = f;
    moved(0, [&](const Motion& m) { term.linearise(m, Definiteness::none, store, f); });
    term.add_product(store, 2, p_, y);
    EXPECT_LT((y / 2 - difference).norm(), 1e-4 * difference.norm() + 1e-3) << term.info().name;
    BlockMatrix A(*parts_.pattern, 3);
    term.add_matrix(store, 2, A);
    A.mirror(1);
    Eigen::VectorXd Ap(x_.size());
    A.multiply(p_, Ap, 1);
    EXPECT_LT((Ap - y).norm(), 1e-11 * y.norm() + 1e-12) << term.info().name;
    term.add_diagonal(store, 2, diagonal);
    for (Eigen::Index i = 0; i < 12; ++i) {
      A.multiply(Eigen::VectorXd::Unit(x_.size(), i), column, 1);
      EXPECT_NEAR(column[i], diagonal[i], 1e-11 * diagonal.norm() + 1e-12) << term.info().name;
    }
  }
}

// A term that is added to sim/term must be added to everything(), or nothing here tries its derivatives.
TEST_F(Terms, AreAllThatThereAre) {
  std::set<std::type_index> here;
  for (const auto& term : parts_.terms) here.insert(typeid(*term));
  std::size_t classes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(RITZ_SOURCE_DIR "/sim/term")) {
    std::ifstream header(entry.path());
    for (std::string line; std::getline(header, line);) classes += line.find(": public Term {") != std::string::npos;
  }
  EXPECT_EQ(here.size() + 1, classes) << "contact, which needs two bodies, has its own: contact_test.cpp";
}

TEST(Construction, OnlyWhatTheSceneNames) {
  const auto names = [](const Scene& scene) {
    std::string all;
    for (const TermInfo& term : System(scene).terms()) all += term.name + ";";
    return all;
  };
  EXPECT_EQ(names(everything()),
            "elastic beam;gravity;traction beam;pressure beam;force beam;untangle beam;damping "
            "beam;obstacle;obstacle;spring beam;");
  Scene bare = test::beam("tet4", 1);
  EXPECT_EQ(names(bare), "elastic beam;gravity;");
  bare.world.gravity = {0, 0, 0};
  EXPECT_EQ(names(bare), "elastic beam;");
}

TEST(Traction, AddsUpToItsValueTimesTheArea) {
  for (const char* element : {"tet4", "tet10", "hex8"}) {
    Scene scene = test::beam(element, 2);
    scene.world.gravity = {0, 0, 0};
    scene.bodies[0].loads.tractions = {Traction{InGroup{"right"}, {30, -20, 50}, 2.0}};
    System system(scene);
    const auto& term = *parts_of(system).model.terms[1];
    const Eigen::VectorXd& X = parts_of(system).model.X;
    const auto store = term.make_store(1);
    for (const auto& [t, share] : {std::pair{0.0, 0.0}, {1.0, 0.5}, {2.0, 1.0}, {9.0, 1.0}}) {
      Eigen::VectorXd f = Eigen::VectorXd::Zero(X.size());
      term.add_forces({X, X, t, 0}, *store, f);
      Vec3 sum = Vec3::Zero(), torque = sum;
      for (Eigen::Index i = 0; i < f.size(); i += 3) {
        sum += f.segment<3>(i);
        torque += (X.segment<3>(i) - Vec3(4, 0.5, 0.5)).cross(f.segment<3>(i));
      }
      EXPECT_LT((sum - share * Vec3(30, -20, 50)).norm(), 1e-12) << element;
      EXPECT_LT(torque.norm(), 1e-12) << element;
    }
  }
}

// On a membrane a load per area acts on its faces; on its edges only where no face is inside the region.
TEST(Traction, OnAMembraneActsOnItsFaces) {
  for (const ElementKind kind : {ElementKind::tri3, ElementKind::tri6}) {
    Scene scene;
    Body body;
    body.name = "sheet";
    body.mesh = generate_sheet({2, 1}, {4, 2}, {1, 1}, kind);
    body.thickness = 0.01;
    body.materials = {MaterialSpec{"stable-neo-hookean", 1e6, 0.3, 1000, ""}};
    scene.world.gravity = {0, 0, 0};
    for (const auto& [low, area] : {std::pair{Vec3(-1, -1, -1), 2.0}, {Vec3(2, -1, -1), 0.01}}) {
      body.loads.tractions = {Traction{Box{low, {3, 2, 1}}, {0, 0, 50}, 0}};
      scene.bodies = {body};
      System system(scene);
      const auto& term = *parts_of(system).model.terms[1];
      const Eigen::VectorXd& X = parts_of(system).model.X;
      Eigen::VectorXd f = Eigen::VectorXd::Zero(X.size());
      term.add_forces({X, X, 1, 0}, *term.make_store(1), f);
      EXPECT_NEAR(f.sum(), 50 * area, 1e-12);
    }
  }
}

// A block on an inclined plane: at rest where mu > tan(slope), sliding with g (sin - mu cos) where mu is less.
TEST(Friction, HoldsABlockOrLetsItSlideAsCoulombSays) {
  const double slope = 0.3, g = 9.81;
  for (const double mu : {0.5, 0.1}) {
    Scene scene;
    Body body;
    body.name = "block";
    body.mesh = generate_box({0.4, 0.4, 0.2}, {2, 2, 1}, {1, 1, 1}, ElementKind::tet4);
    body.mesh.X.row(2).array() += 3e-4;
    body.materials = {MaterialSpec{"stable-neo-hookean", 1e6, 0.3, 1000, ""}};
    body.damping = {0, 5e-3};
    scene.bodies = {body};
    scene.world.gravity = {g * std::sin(slope), 0, -g * std::cos(slope)};
    scene.obstacles = {Obstacle{Plane{{0, 0, 0}, {0, 0, 1}}, mu}};
    scene.time.substeps = 4;
    test::Stepped run(scene);
    const auto velocity = [&] {
      const Measures m = run.system.measure(run.state);
      return m.p.x() / (1000 * 0.4 * 0.4 * 0.2);
    };
    run.steps(120);
    const double early = velocity();
    run.steps(120);
    const double rate = (velocity() - early) / 0.5,
                 expected = std::max(0.0, g * (std::sin(slope) - mu * std::cos(slope)));
    EXPECT_NEAR(rate, expected, 0.05 * g * std::sin(slope)) << "mu = " << mu;
    EXPECT_GT(run.state.x.size(), 0);
    for (Eigen::Index i = 2; i < run.state.x.size(); i += 3) EXPECT_GT(run.state.x[i], 0) << "through the plane";
  }
}

// A ball thrown at a sphere never enters it, however large the step.
TEST(Obstacle, IsNeverEntered) {
  for (const int fps : {24, 240}) {
    Scene scene;
    Body body;
    body.name = "cube";
    body.mesh = generate_box({0.5, 0.5, 0.5}, {3, 3, 3}, {1, 1, 1}, ElementKind::tet4);
    body.materials = {MaterialSpec{"stable-neo-hookean", 2e5, 0.4, 1000, ""}};
    body.velocity = {0, 0, -15};
    scene.bodies = {body};
    scene.world.gravity = {0, 0, -9.81};
    scene.obstacles = {Obstacle{Sphere{{0.2, 0.25, -1}, 0.8}, 0.2}};
    scene.time.fps = fps;
    test::Stepped run(scene);
    for (int k = 0; k < fps; ++k) {
      run.last = run.stepper->step(run.state);
      ASSERT_EQ(run.last.failure, "");
      for (Eigen::Index i = 0; i < run.state.x.size(); i += 3)
        ASSERT_GT((run.state.x.segment<3>(i) - Vec3(0.2, 0.25, -1)).norm(), 0.8) << "fps " << fps << " step " << k;
    }
  }
}

// alpha alone: a free body slows as exp(-alpha t); beta alone leaves its momentum as it is.
TEST(Damping, AlphaDrainsMomentumBetaDoesNot) {
  for (const auto& [alpha, beta] : {std::pair{2.0, 0.0}, {0.0, 0.05}}) {
    Scene scene = test::free_body({"tet4", false}, "stable-neo-hookean");
    scene.bodies[0].velocity = {1, 0, 0};
    scene.bodies[0].damping = {alpha, beta};
    scene.time.integrator = "sdirk2";
    scene.time.substeps = 4;
    scene.solver.tolerance = 1e-10;
    test::Stepped run(scene);
    const double before = run.system.measure(run.state).p.x();
    run.steps(240);
    EXPECT_NEAR(run.system.measure(run.state).p.x() / before, std::exp(-alpha), 1e-5);
  }
}

}  // namespace
}  // namespace sim
