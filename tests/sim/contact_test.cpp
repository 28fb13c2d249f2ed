// Contact between bodies: derivatives of its term, and what it does to them.
#include <gtest/gtest.h>

#include "sim/solve/tangent_operator.h"
#include "tests/sim/contact_support.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

// Two boxes within each other's reach, turned and bent a little so that every kind of pair is near; friction.
Scene near_each_other(int dimension) {
  Scene scene;
  scene.world.gravity = {0, 0, 0};
  scene.dimension = dimension;
  if (dimension == 3) {
    scene.bodies = {test::box_body("low", {1, 1, 1}, 2, {0, 0, 0}),
                    test::box_body("top", {1, 1, 1}, 2, {0.2, 1.01, 0.1})};
    rotate(scene.bodies[0].mesh, {0, 1, 0}, 0.3);  // some edges are nearly parallel
  } else {
    for (const char* name : {"low", "top"}) {
      Body body;
      body.name = name;
      body.mesh = generate_rectangle({1, 1}, {2, 2}, {1, 1}, ElementKind::tri3);
      if (body.name == "top") translate(body.mesh, {0.2, 1.01, 0});
      body.materials = {MaterialSpec{"linear", 1e5, 0.3, 1000, ""}};
      scene.bodies.push_back(body);
    }
  }
  Contact contact;
  contact.distance = 0.05;
  contact.friction = 0.4;
  scene.contacts = {contact};
  return scene;
}

class ContactTerms : public ::testing::TestWithParam<int> {
 protected:
  ContactTerms()
      : system_(near_each_other(GetParam())),
        model_(parts_of(system_).model),
        term_(*model_.contacts.at(0)),
        store_(term_.make_store(1)) {
    x_ = model_.X + test::random_vector(model_.dofs(), 2e-3, 1);
    v_ = test::random_vector(model_.dofs(), 0.01, 2);
    p_ = test::random_vector(model_.dofs(), 1, 3);
    term_.begin_step({x_, v_, 0, 0}, *store_);
  }
  template <class F>
  auto moved(double e, const F& f) {
    const Eigen::VectorXd x = x_ + e * p_, v = v_ + rate_ * e * p_;
    return f(Motion{x, v, 0.2, rate_});
  }
  Eigen::VectorXd force(const Motion& m) {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(x_.size());
    term_.add_forces(m, *store_, f);
    return f;
  }

  System system_;
  const Model& model_;
  const ContactTerm& term_;
  std::unique_ptr<Term::Store> store_;
  Eigen::VectorXd x_, v_, p_;
  double rate_ = 60;
};

TEST_P(ContactTerms, ForceIsMinusTheGradient) {
  const double e = 1e-7;
  const auto energy = [&](const Motion& m) { return term_.energy(m, *store_); };
  const Eigen::VectorXd f = moved(0, [&](const Motion& m) { return force(m); });
  EXPECT_GT(f.norm(), 0);
  EXPECT_NEAR(-f.dot(p_), (moved(e, energy) - moved(-e, energy)) / (2 * e), 2e-6 * f.norm() * p_.norm());
}

TEST_P(ContactTerms, ProductDiagonalAndMatrixAreTheDerivativeOfTheForce) {
  const int D = GetParam();
  const double e = 1e-7;
  const Eigen::VectorXd difference =
      (moved(-e, [&](const Motion& m) { return force(m); }) - moved(e, [&](const Motion& m) { return force(m); })) /
      (2 * e);
  Eigen::VectorXd f = Eigen::VectorXd::Zero(x_.size()), y = f, diagonal = f, column = f;
  moved(0, [&](const Motion& m) { term_.linearise(m, Definiteness::none, *store_, f); });
  term_.add_product(*store_, 2, p_, y);
  EXPECT_LT((y / 2 - difference).norm(), 1e-4 * difference.norm());
  BlockMatrix A(*model_.pattern, D);
  std::vector<NodePair> pairs;
  term_.add_pairs(*store_, pairs);
  A.set_zero(pairs);
  EXPECT_FALSE(A.outside().empty());
  term_.add_matrix(*store_, 2, A);
  A.mirror(1);
  Eigen::VectorXd Ap(x_.size());
  A.multiply(p_, Ap, 1);
  EXPECT_LT((Ap - y).norm(), 1e-11 * y.norm());
  term_.add_diagonal(*store_, 2, diagonal);
  for (Eigen::Index i = 0; i < x_.size(); ++i) {
    A.multiply(Eigen::VectorXd::Unit(x_.size(), i), column, 1);
    EXPECT_NEAR(column[i], diagonal[i], 1e-11 * diagonal.norm());
  }
}

TEST_P(ContactTerms, ClampedTangentIsPositiveSemidefinite) {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(x_.size());
  moved(0, [&](const Motion& m) { term_.linearise(m, Definiteness::clamp, *store_, f); });
  for (unsigned seed = 10; seed < 60; ++seed) {
    const Eigen::VectorXd p = test::random_vector(x_.size(), 1, seed);
    Eigen::VectorXd y = Eigen::VectorXd::Zero(x_.size());
    term_.add_product(*store_, 1, p, y);
    EXPECT_GE(p.dot(y), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(InPlaneAndSpace, ContactTerms, ::testing::Values(2, 3));

TEST(Contact, NoneWhereNotNamed) {
  Scene scene = near_each_other(3);
  scene.contacts.clear();
  for (const TermInfo& term : System(scene).terms()) EXPECT_EQ(term.name.find("contact"), std::string::npos);
}

// A box comes to rest on another; the force between them is then its weight.
TEST(Contact, BoxRestsOnBox) {
  for (const char* integrator : {"backward-euler", "bdf2"}) {
    Scene scene = test::two_boxes(2, 0.02);
    scene.time.integrator = integrator;
    scene.bodies[1].damping.alpha = 5;
    test::Stepped run(scene);
    for (int k = 0; k < 120; ++k) {
      run.steps(1);
      ASSERT_EQ(test::count_crossings(scene, run.state.x), 0) << integrator << " step " << k;
    }
    const ContactReport report = run.system.contacts(run.state).at(0);
    EXPECT_GT(report.gap, 0);
    EXPECT_LT(report.gap, 1e-3);
    EXPECT_NEAR(report.force.y(), -9810, 400) << integrator;
  }
}

// Nothing else acts, so momentum stays; and forces of a pair lie in one line, so they have no moment about where the
// nodes are at the step's end: sum m x_{n+1} x (v_{n+1} - v_n) = h sum x_{n+1} x f_{n+1} = 0, in backward Euler.
TEST(Contact, CollisionInFreeFlightKeepsMomentum) {
  Scene scene;
  scene.world.gravity = {0, 0, 0};
  scene.bodies = {test::box_body("a", {1, 1, 1}, 2, {0, 0, 0}), test::box_body("b", {1, 1, 1}, 2, {1.05, 0.3, 0.2})};
  scene.bodies[0].velocity = {3, 0, 0};
  scene.contacts = {Contact{}};
  scene.solver.tolerance = 1e-12;
  test::Stepped run(scene);
  const Measures start = run.system.measure(run.state);
  const double p = start.p.norm();
  double impulse = 0;  // of all pairs
  for (int k = 0; k < 30; ++k) {
    const State before = run.state;
    run.steps(1);
    for (const ContactReport& report : run.system.contacts(run.state)) impulse += report.force.norm() / 60;
    State change = run.state;
    change.v -= before.v;
    const Measures turned = run.system.measure(change);  // momenta of x_{n+1} and v_{n+1} - v_n
    EXPECT_LT(turned.p.norm(), 1e-10 * p);
    EXPECT_LT(turned.L.norm(), 1e-10 * p * 1.5);
  }
  const Measures end = run.system.measure(run.state);
  EXPECT_GT(impulse, 0.3 * p);
  EXPECT_LT((end.p - start.p).norm(), 1e-10 * p);
  EXPECT_LE(end.kinetic + end.elastic, start.kinetic * (1 + 1e-9));
}

// Whatever the speed and the step: the way is looked at, not only its end.
TEST(Contact, NothingPassesThroughAtAnySpeedAndStep) {
  for (const double speed : {5.0, 40.0})
    for (const int fps : {1000, 60, 1}) {
      Scene scene = test::two_boxes(1, 0.5);
      scene.bodies[1].mesh = generate_box({0.2, 0.2, 0.2}, {1, 1, 1}, {1, 1, 1}, ElementKind::tet4);
      translate(scene.bodies[1].mesh, {0.4, 1.3, 0.4});
      scene.bodies[1].velocity = {0, -speed, 0};
      scene.time.fps = fps;
      System system(scene);
      State state = system.initial_state();
      const auto stepper = make_stepper(system, 1);
      for (int k = 0; k < 12; ++k) {
        const StepReport report = stepper->step(state);
        ASSERT_EQ(report.failure, "");
        ASSERT_EQ(test::count_crossings(scene, state.x), 0) << speed << " m/s, step " << k << " of 1/" << fps << " s";
        // The small box has not come out below; in seconds it may well have fallen off the side.
        const int last = system.bodies()[1].first_node;
        if (fps > 1) {
          EXPECT_GT(state.x[3 * last + 1], 0) << speed << " m/s, 1/" << fps << " s";
        }
      }
    }
}

// A pinned body is driven into another, much further a step than the gap, and pushes it along.
TEST(Contact, PrescribedBodyPushesAnother) {
  Scene scene = test::two_boxes(2, 0.01);
  scene.world.gravity = {0, 0, 0};
  Pin driven{Box{{-1, -1, -1}, {2, 2, 2}}, "xyz", {}, {}};
  driven.motion = {Keyframe{}, Keyframe{}};
  driven.motion[1].t = 1;
  driven.motion[1].translate = {0, 2, 0};
  scene.bodies[0].pins = {driven};
  test::Stepped run(scene);
  for (int k = 0; k < 30; ++k) {
    run.steps(1);
    ASSERT_EQ(test::count_crossings(scene, run.state.x), 0) << "step " << k;
  }
  const int last = run.system.bodies()[1].first_node;
  EXPECT_GT(run.state.x[3 * last + 1], 1.9);
}

// Between two that close on it there is no room: reported, not crossed.
TEST(Contact, WhatCannotMakeRoomIsReported) {
  Scene scene = test::two_boxes(1, 0.01);
  scene.bodies[1].pins = {Pin{Box{{-9, -9, -9}, {9, 9, 9}}, "xyz", {}, {}}};
  scene.bodies[1].pins[0].motion = {Keyframe{}, Keyframe{}};
  scene.bodies[1].pins[0].motion[1].t = 1;
  scene.bodies[1].pins[0].motion[1].translate = {0, -1, 0};
  scene.bodies[0].pins[0].where = Box{{-9, -9, -9}, {9, 9, 9}};
  System system(scene);
  State state = system.initial_state();
  const auto stepper = make_stepper(system, 1);
  const StepReport report = stepper->step(state);
  EXPECT_NE(report.failure.find("prescribed"), std::string::npos) << report.failure;
  EXPECT_EQ(test::count_crossings(scene, state.x), 0);
}

TEST(Contact, BodyDoesNotPassThroughItself) {
  // A strip in the plane, bent until its ends meet.
  Scene scene;
  scene.dimension = 2;
  Body body;
  body.name = "strip";
  body.mesh = generate_rectangle({2, 0.1}, {20, 1}, {1, 1}, ElementKind::tri3);
  body.materials = {MaterialSpec{"stable-neo-hookean", 1e4, 0.3, 1000, ""}};
  for (const double end : {0.0, 2.0}) {
    Pin pin{Box{{end - 1e-6, -1, -1}, {end + 1e-6, 2, 1}}, "xy", {}, 0.9};
    pin.motion = {Keyframe{}, Keyframe{}};
    pin.motion[1].t = 0.8;
    pin.motion[1].centre = {end, 0.05, 0};
    pin.motion[1].translate = {end == 0 ? 0.9 : -0.9, 0, 0};
    pin.motion[1].degrees = end == 0 ? 90 : -90;
    body.pins.push_back(pin);
  }
  scene.bodies = {body};
  scene.contacts = {Contact{{"strip", "strip"}, 0, {}, {}, {}}};
  test::Stepped run(scene);
  for (int k = 0; k < 60; ++k) {
    run.steps(1);
    ASSERT_EQ(test::count_crossings(scene, run.state.x), 0) << "step " << k;
  }
}

std::string error_of(const Scene& scene) {
  try {
    System system(scene);
  } catch (const InputError& error) {
    return error.key + ": " + error.what();
  }
  return "";
}

TEST(Contact, NeedsStepsThatAreCut) {
  Scene scene = test::two_boxes(2, 0.1);
  scene.solver.newton = NewtonKind::pure;
  EXPECT_TRUE(error_of(scene).starts_with("solver.newton: \"pure\" is not for scenes with a [[contact]]"));
}

TEST(Contact, MistakesAreNamed) {
  Scene scene = test::two_boxes(1, 0.1);
  scene.contacts[0].between = {"low", "tap"};
  EXPECT_EQ(error_of(scene), "contact.0.between: \"tap\" is not the name of a body; there are: low, top");
  scene.contacts[0].between = {"low", "top"};
  scene.contacts.push_back(Contact{{"top", "low"}, 0, {}, {}, {}});
  EXPECT_NE(error_of(scene).find("contact.1.between"), std::string::npos);
  scene.contacts.resize(1);
  for (const char* scheme : {"implicit-midpoint", "linearly-implicit", "symplectic-euler", "central-difference"}) {
    scene.time.integrator = scheme;
    EXPECT_NE(error_of(scene).find("time.integrator"), std::string::npos) << scheme;
  }
}

}  // namespace
}  // namespace sim
