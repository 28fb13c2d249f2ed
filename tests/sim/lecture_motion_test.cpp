// What the pages of the lecture on Newton's method, steps and damping show, against numbers that another program
// computed.
#include <Eigen/Eigenvalues>

#include "sim/build/parts.h"
#include "sim/study/acceleration.h"
#include "sim/study/body_motion.h"
#include "sim/study/element_view.h"
#include "sim/study/growth.h"
#include "sim/study/modes.h"
#include "sim/study/pure_newton.h"
#include "sim/study/ring.h"
#include "tests/sim/lecture_support.h"

namespace sim {
namespace {

using test::digits, test::expect_near, test::Json, test::lecture_data, test::single;

TEST(Lecture, DefinitenessOfOneElement) {
  const Json cases = lecture_data("definiteness.json");
  for (const Json& reference : cases.list) {
    const Body body =
        single(reference["X"].matrix(), reference["model"].text, reference["E"].number, reference["nu"].number);
    const Eigen::MatrixXd x = reference["F"].matrix() * body.mesh.X;
    const auto eigenvalues = [](const Eigen::MatrixXd& K) {
      return Eigen::VectorXd(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues());
    };
    const Eigen::MatrixXd K = element_stiffness(body, 0, x, Definiteness::none);
    const std::string what = reference["model"].text;
    expect_near(eigenvalues(K), reference["K_e_eigenvalues_none"].vector(), what + " none");
    for (const auto& [fix, name] : {std::pair{Definiteness::clamp, "clamp"}, std::pair{Definiteness::abs, "abs"}}) {
      const Eigen::MatrixXd by_stress = element_stiffness(body, 0, x, fix), by_matrix = made_definite(K, fix);
      const std::string of = std::string(name) + "_of_";
      expect_near(eigenvalues(by_stress), reference["K_e_eigenvalues_" + of + "dPdF"].vector(), what + " " + of);
      expect_near(eigenvalues(by_matrix), reference["K_e_eigenvalues_" + of + "K_e"].vector(), what + " " + of);
      const double distance = reference["frobenius_distance_" + of + "dPdF_to_K_e"].number;
      EXPECT_NEAR((by_stress - K).norm(), distance, digits * (1 + distance)) << what;
      const double nearest = reference["frobenius_distance_" + of + "K_e_to_K_e"].number;
      EXPECT_NEAR((by_matrix - K).norm(), nearest, digits * (1 + nearest)) << what;
    }
  }
}

// solver.newton = "pure" in a static scene, a single iteration a step: its iterates are those of the dense study, which
// shares nothing with it but the energy's derivatives.
void expect_same_path(Scene scene, const Eigen::VectorXd& start, Definiteness fix, const NewtonPath& path) {
  scene.time.integrator = "static";
  scene.solver.newton = NewtonKind::pure;
  scene.solver.definiteness = fix;
  scene.solver.max_iterations = 1;
  scene.solver.on_failure = OnFailure::accept;
  scene.solver.tolerance = 1e-9;
  const System system(scene);
  const auto stepper = make_stepper(system, 1);
  State state = system.initial_state();
  state.x = start;
  for (int k = 1; k <= path.iterations(); ++k) {
    EXPECT_EQ(stepper->step(state).failure, "");
    EXPECT_LT((state.x - path.points[static_cast<std::size_t>(k)]).cwiseAbs().maxCoeff(), 1e-9) << k;
  }
  const Eigen::VectorXd end = state.x;
  const StepReport report = stepper->step(state);
  EXPECT_LT((state.x - end).cwiseAbs().maxCoeff(), 1e-9) << "it is at its end";
  EXPECT_EQ(report.converged, !path.singular);
  if (path.singular) {
    EXPECT_EQ(report.reason, "the matrix is singular");
  }
}

// landscape.json: where each variant of Newton's method goes, and in how many steps.
TEST(Lecture, PathsOfNewtonOnALandscape) {
  const Json cases = lecture_data("landscape.json");
  for (const Json& reference : cases.list) {
    Scene scene;
    scene.dimension = 2;
    scene.world.gravity.setZero();
    scene.solver.linear = LinearSolverKind::cholmod;
    Body body = single(reference["X"].matrix(), reference["model"].text, reference["E"].number, reference["nu"].number);
    body.pins = {Pin{Box{{-0.1, -0.1, -1}, {1.1, 0.1, 1}}, "xyz", {}, {}, false}};
    scene.bodies = {body};
    const System system(scene);
    Eigen::VectorXd start = system.initial_state().x;
    start.tail(2) = reference["start"].vector();
    for (const auto& [fix, name] : {std::pair{Definiteness::none, "none"}, std::pair{Definiteness::clamp, "clamp"},
                                    std::pair{Definiteness::abs, "abs"}}) {
      const Json& path = reference["paths"][name];
      const NewtonPath found = pure_newton(system, start, fix);
      const std::string what = reference["model"].text + " " + name;
      SCOPED_TRACE(what);
      expect_same_path(scene, start, fix, found);
      // Where round-off cuts the last step it is a matter of taste whether there is one more.
      const auto& steps = path["step_fraction"].list;
      const bool cut = !steps.empty() && steps.back().number < 1;
      EXPECT_NEAR(found.iterations(), path["iterations"].number, cut ? 1 : 0) << what;
      for (std::size_t k = 0; k < found.points.size() && k < path["points"].list.size(); ++k)
        EXPECT_LT((found.points[k].tail(2) - path["points"][k].vector()).cwiseAbs().maxCoeff(), 1e-8)
            << what << " " << k;
      expect_near(found.end_eigenvalues, path["end_eigenvalues"].vector(), what);
      EXPECT_EQ(found.singular, !path["note"].text.empty()) << what;
      if (found.singular) continue;
      const std::string end = path["end_is"].text;
      EXPECT_EQ(found.end, end == "minimum"  ? Stationary::minimum
                           : end == "saddle" ? Stationary::saddle
                                             : Stationary::maximum)
          << what;
    }
  }
}

// The landscape is that of U alone: neither damping nor what a step would be solved by has a part in it.
TEST(Lecture, PathsOfNewtonDependOnThePotentialOnly) {
  const Json reference = lecture_data("landscape.json").list[0];
  Scene scene;
  scene.dimension = 2;
  Body body = single(reference["X"].matrix(), reference["model"].text, reference["E"].number, reference["nu"].number);
  body.pins = {Pin{Box{{-0.1, -0.1, -1}, {1.1, 0.1, 1}}, "xyz", {}, {}, false}};
  scene.bodies = {body};
  scene.solver.linear = LinearSolverKind::cholmod;
  const System with_matrix(scene);
  scene.bodies[0].damping = {0.3, 0.1};
  scene.time.integrator = "central-difference";
  const System without_matrix(scene);
  Eigen::VectorXd start = with_matrix.initial_state().x;
  start.tail(2) = reference["start"].vector();
  for (const Definiteness fix : {Definiteness::none, Definiteness::abs}) {
    const NewtonPath a = pure_newton(with_matrix, start, fix), b = pure_newton(without_matrix, start, fix);
    ASSERT_EQ(a.iterations(), b.iterations());
    EXPECT_GT(a.iterations(), 3);
    EXPECT_EQ(a.points.back(), b.points.back());
    EXPECT_EQ(a.energy, b.energy);
  }
}

// From noise the fastest mode grows 1.32658-fold in a step of 1.01 times the limit, and stays below the limit.
TEST(Lecture, ExplicitStepsGrowBeyondTheLimitOnly) {
  EXPECT_NEAR(growth_per_step(1.01), 1.326584427, digits);
  EXPECT_NEAR(growth_per_step(1.05), 1.877328045, digits);
  EXPECT_NEAR(growth_per_step(1), 1, digits);
  EXPECT_EQ(growth_per_step(0.5), 1);
  Scene scene;
  scene.dimension = 2;
  Body body;
  body.mesh = generate_rectangle({4, 1}, {16, 4}, {1, 1}, ElementKind::tri3);
  body.materials = {MaterialSpec{"stable-neo-hookean", 1e6, 0.3, 1000, ""}};
  body.pins = {Pin{InGroup{"left"}, "xy", {}, {}, false}};
  scene.bodies = {body};
  const double limit = 2 / fastest_frequency(scene, 0);
  EXPECT_NEAR(limit / 0.005573111556, 1, digits);
  const Growth beyond = growth(scene, "central-difference", 1.01 * limit, 80);
  EXPECT_NEAR(beyond.per_step(), 1.326584427, 1e-3);
  const std::vector<double>& above = beyond.reach;
  ASSERT_EQ(above.size(), 81u);
  ASSERT_EQ(beyond.x.size(), 81u);
  EXPECT_EQ((beyond.x[60] - beyond.x[0]).cwiseAbs().maxCoeff(), above[60]);
  EXPECT_NEAR(std::pow(above[65] / above[40], 1.0 / 25), 1.326584427, 1e-3);
  const std::vector<double> below = growth(scene, "central-difference", 0.99 * limit, 400).reach;
  EXPECT_LT(*std::max_element(below.begin(), below.end()), 1e-9);
  EXPECT_NEAR(growth(scene, "central-difference", 0.99 * limit, 400).per_step(), 1, 2e-3);
  const Growth implicit = growth(scene, "backward-euler", 3 * limit, 400);  // more than two periods of the slowest mode
  EXPECT_LT(implicit.reach.back(), 1e-10);
  EXPECT_LE(implicit.per_step(), 1);
}

// M a = f: what an explicit step adds to the velocities, for both masses, under weight and damping; a pinned node
// stays.
TEST(Lecture, AccelerationsAreThoseOfAStep) {
  for (const MassMatrix mass : {MassMatrix::lumped, MassMatrix::consistent}) {
    Scene scene;
    scene.dimension = 2;
    Body body;
    body.mesh = generate_rectangle({4, 1}, {6, 2}, {1, 1}, ElementKind::tri3);
    body.materials = {MaterialSpec{"stable-neo-hookean", 1e6, 0.3, 1000, ""}};
    body.pins = {Pin{InGroup{"left"}, "xy", {}, {}, false}};
    body.mass = mass;
    body.damping.alpha = 0.7;
    scene.bodies = {body};
    scene.time.integrator = "symplectic-euler";
    scene.time.fps = 1000;
    const System system(scene);
    State state = system.initial_state();
    const auto stepper = make_stepper(system, 1);
    for (int k = 0; k < 20; ++k) ASSERT_EQ(stepper->step(state).failure, "");
    const Eigen::VectorXd a = accelerations(system, state), v = state.v;
    ASSERT_EQ(stepper->step(state).failure, "");
    EXPECT_LT((v + a / 1000 - state.v).cwiseAbs().maxCoeff(), 1e-12 * a.cwiseAbs().maxCoeff());
    EXPECT_GT(a.cwiseAbs().maxCoeff(), 1);
    for (const int node : system.pinned_nodes(0)) EXPECT_EQ(a.segment(2 * node, 2).norm(), 0);
  }
}

// rayleigh.json: ratio of successive maxima of the second mode, trapezoidal at 1/240 s; momentum under alpha.
TEST(Lecture, DampingRingsDownAndDrainsMomentum) {
  Scene scene;
  scene.dimension = 2;
  scene.world.gravity.setZero();
  scene.time.integrator = "trapezoidal";
  scene.time.fps = 240;
  scene.solver.tolerance = 1e-12;
  Body beam;
  beam.mesh = generate_rectangle({4, 1}, {16, 4}, {1, 1}, ElementKind::quad4);
  beam.materials = {MaterialSpec{"stable-neo-hookean", 1e6, 0.3, 1000, ""}};
  beam.pins = {Pin{InGroup{"left"}, "xy", {}, {}, false}};
  beam.damping.beta = 0.02;
  beam.start.shape = "mode";
  beam.start.mode = 2;
  beam.start.amount = 1e-5;
  scene.bodies = {beam};
  const Modes modes = vibration_modes(scene, 0, 2);
  EXPECT_NEAR(modes.omega[1] / 10.25057394, 1, digits);
  const System system(with_modes_started(scene));
  State state = system.initial_state();
  const auto stepper = make_stepper(system, 1);
  std::vector<double> q;
  for (int k = 0; k < 400; ++k) {
    q.push_back(modal_motion(system, state, 0, modes.shape.col(1)).q);
    ASSERT_EQ(stepper->step(state).failure, "");
  }
  const std::vector<double> tops = maxima(q);
  ASSERT_GE(tops.size(), 2u);
  EXPECT_NEAR(tops[1] / tops[0], 0.5234695589, 2e-4);

  Scene flight = scene;
  flight.bodies[0] = test::free_body({"quad4", false}, "stvk").bodies[0];
  flight.bodies[0].damping = {0.5, 0};
  flight.bodies[0].velocity = {1, 0, 0};
  flight.time.fps = 60;
  const System flying(flight);
  State flyer = flying.initial_state();
  const double start = momentum(flying, flyer, 0).linear.x();
  const auto fly = make_stepper(flying, 1);
  for (int k = 0; k < 60; ++k) ASSERT_EQ(fly->step(flyer).failure, "");
  EXPECT_NEAR(momentum(flying, flyer, 0).linear.x() / start, 0.6065289047, 1e-8);
}

TEST(Lecture, MaximaAreTopsOfParabolas) {
  std::vector<double> values;
  for (int k = 0; k < 12; ++k) values.push_back(3 - 0.5 * (k - 4.3) * (k - 4.3));
  const std::vector<double> tops = maxima(values);
  ASSERT_EQ(tops.size(), 1u);
  EXPECT_NEAR(tops[0], 3, 1e-12);
}

}  // namespace
}  // namespace sim
