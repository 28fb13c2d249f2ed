// What the pages of the lecture show, against numbers that another program computed: tests/data/lecture (README.md
// there).
#include <Eigen/Eigenvalues>

#include "sim/build/parts.h"
#include "sim/stepper.h"
#include "sim/study/acceleration.h"
#include "sim/study/body_motion.h"
#include "sim/study/element_view.h"
#include "sim/study/force_check.h"
#include "sim/study/growth.h"
#include "sim/study/modes.h"
#include "sim/study/pure_newton.h"
#include "sim/study/ring.h"
#include "sim/study/shape_functions.h"
#include "tests/sim/json.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

using test::Json;
using test::lecture_data;

constexpr double digits = 1e-8;

// Equal to 1e-8 of the largest entry.
void expect_near(const Eigen::MatrixXd& found, const Eigen::MatrixXd& reference, const std::string& what) {
  ASSERT_EQ(found.rows(), reference.rows()) << what;
  ASSERT_EQ(found.cols(), reference.cols()) << what;
  const double scale = std::max(reference.cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((found - reference).cwiseAbs().maxCoeff(), digits * scale) << what << "\n" << found << "\n" << reference;
}

// A body of one element with these rest positions (rows).
Body single(const Eigen::MatrixXd& X_rows, const std::string& model, double young, double poisson) {
  Body body;
  body.mesh.kind = X_rows.cols() == 2 ? ElementKind::tri3 : ElementKind::tet4;
  body.mesh.X = X_rows.transpose();
  body.mesh.elements.resize(X_rows.rows(), 1);
  for (int a = 0; a < X_rows.rows(); ++a) body.mesh.elements(a, 0) = a;
  body.materials = {MaterialSpec{model, young, poisson, 1000, ""}};
  return body;
}

TEST(Lecture, XRayOfATriangleAndOfATet) {
  const Json reference = lecture_data("element.json");
  for (const char* which : {"triangle", "tet"}) {
    const Json& element = reference[which];
    const Eigen::MatrixXd x = element["x"].matrix().transpose();
    for (const auto& [model, expected] : element["materials"].table) {
      const Body body = single(element["X"].matrix(), model, element["E"].number, element["nu"].number);
      const ElementView view = view_element(body, 0, x);
      const std::string what = std::string(which) + " " + model;
      expect_near(view.Dm, element["D_m"].matrix(), what);
      expect_near(view.Dm_inverse, element["D_m_inverse"].matrix(), what);
      expect_near(view.Ds, element["D_s"].matrix(), what);
      expect_near(view.F, element["F"].matrix(), what);
      expect_near(view.stretches, element["principal_stretches"].vector(), what);
      EXPECT_NEAR(view.J, element["J"].number, digits) << what;
      EXPECT_NEAR(view.measure, element["measure"].number, digits) << what;
      EXPECT_NEAR(view.psi, expected["Psi"].number, digits * expected["Psi"].number) << what;
      EXPECT_NEAR(view.energy(), expected["U"].number, digits * expected["U"].number) << what;
      expect_near(view.P, expected["P"].matrix(), what);
      expect_near(view.f.transpose(), expected["f_rows"].matrix(), what);
      EXPECT_LT(view.force_sum.norm(), 1e-10 * view.f.norm()) << what;
      const Json& torque = expected["torque"];
      EXPECT_NEAR(view.torque, torque.list.empty() ? torque.number : torque.vector().norm(), digits * view.f.norm())
          << what;
    }
  }
}

// What is looked into is what the program steps with: equal forces of every element, summed, to round-off.
TEST(Lecture, XRayAddsUpToTheForcesOfTheSystem) {
  for (const char* model : test::models) {
    Scene scene = test::free_body({"tri3", false}, model, 3);
    scene.bodies[0].start.shape = "affine";
    scene.bodies[0].start.matrix = {1.2, 0.1, -0.2, 0.9};
    const System system(scene);
    const State state = system.initial_state();
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(state.x.size());
    const Mesh& mesh = scene.bodies[0].mesh;
    for (int e = 0; e < mesh.element_count(); ++e) {
      const ElementView view = view_element(scene.bodies[0], e, element_nodes(mesh, e, 0, state.x));
      for (Eigen::Index a = 0; a < 3; ++a) sum.segment(2 * mesh.elements(a, e), 2) += view.f.col(a);
    }
    const ForceCheck check = check_forces(system, state);
    EXPECT_LT((sum - check.galerkin).cwiseAbs().maxCoeff(), 1e-12 * 1e5) << model;
    EXPECT_LT(check.difference, 1e-8 * 1e5) << model;
  }
}

TEST(Lecture, ElementsThatCannotBeLookedIntoAreRefused) {
  Scene scene = test::free_body({"quad4", false}, "stvk");
  EXPECT_THROW(view_element(scene.bodies[0], 0, Eigen::MatrixXd::Zero(2, 3)), InputError);
  scene = test::free_body({"tri3", false}, "stvk");
  EXPECT_THROW(view_element(scene.bodies[0], 100, Eigen::MatrixXd::Zero(2, 3)), InputError);
}

TEST(Lecture, ShapeFunctionsAtAPoint) {
  const Json reference = lecture_data("shape_functions.json");
  for (const auto& [name, element] : reference.table) {
    Mesh mesh;
    mesh.kind = find_element(name)->kind;
    const Eigen::MatrixXd corners = element["corners"].matrix().transpose();
    const int nodes = info(mesh.kind).nodes;
    mesh.X.resize(2, nodes);
    mesh.X.leftCols(corners.cols()) = corners;
    for (const auto& [a, b, middle] : info(mesh.kind).edges)
      if (middle >= 0) mesh.X.col(middle) = (corners.col(a) + corners.col(b)) / 2;
    mesh.elements.resize(nodes, 1);
    for (int a = 0; a < nodes; ++a) mesh.elements(a, 0) = a;
    const Eigen::Vector2d xi = element["xi"].vector();
    const ShapeValues values = shape_values(mesh, {0, xi});
    expect_near(values.X, element["X"].vector(), name);
    expect_near(values.N, element["N"].vector(), name);
    expect_near(values.dN_dX, element["dN_dX"].matrix(), name);
    EXPECT_NEAR(values.N.sum(), 1, 1e-15) << name;
    EXPECT_LT((find_point_of_element(mesh, values.X).xi - xi).norm(), 1e-12) << name;
  }
}

// interpolation.csv: function,element,n,L2,H1_seminorm,max
TEST(Lecture, InterpolationErrors) {
  std::ifstream file(std::string(RITZ_SOURCE_DIR) + "/tests/data/lecture/interpolation.csv");
  std::string line;
  std::getline(file, line);
  int rows = 0;
  while (std::getline(file, line)) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 6u);
    const int n = std::stoi(cells[2]);
    const InterpolationError error =
        interpolation_error(generate_rectangle({1, 1}, {n, n}, {1, 1}, find_element(cells[1])->kind));
    EXPECT_NEAR(error.L2 / std::stod(cells[3]), 1, digits) << line;
    EXPECT_NEAR(error.H1_seminorm / std::stod(cells[4]), 1, digits) << line;
    EXPECT_NEAR(error.max / std::stod(cells[5]), 1, digits) << line;
    ++rows;
  }
  EXPECT_GE(rows, 12);
}

TEST(Lecture, ForceAlgorithmOnTwoTriangles) {
  const Json reference = lecture_data("force_algorithm.json");
  Scene scene;
  scene.dimension = 2;
  scene.world.gravity.setZero();
  scene.solver.linear = LinearSolverKind::cholmod;
  Body body;
  body.mesh = generate_rectangle({1, 1}, {1, 1}, {1, 1}, ElementKind::tri3);
  body.materials = {MaterialSpec{"stable-neo-hookean", 1e5, 0.3, 1000, ""}};
  body.start.shape = "nodes";
  for (const Json& x : reference["x"].list) body.start.nodes.push_back({x[0].number, x[1].number, 0});
  scene.bodies = {body};
  const System system(scene);
  const State state = system.initial_state();
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(2, 4);
  for (const Json& step : reference["steps"].list) {
    const int e = static_cast<int>(step["element"].number);
    const ElementView view = view_element(body, e, element_nodes(body.mesh, e, 0, state.x));
    for (Eigen::Index a = 0; a < 3; ++a)
      EXPECT_EQ(body.mesh.elements(a, e), step["nodes"][static_cast<std::size_t>(a)].number);
    expect_near(view.x.transpose(), step["gather_x"].matrix(), "gather");
    expect_near(view.Ds, step["D_s"].matrix(), "D_s");
    expect_near(view.F, step["F"].matrix(), "F");
    expect_near(view.P, step["P"].matrix(), "P");
    expect_near(view.f.transpose(), step["f_element_rows"].matrix(), "f");
    for (Eigen::Index a = 0; a < 3; ++a) sum.col(body.mesh.elements(a, e)) += view.f.col(a);
    expect_near(sum.transpose(), step["accumulator_after"].matrix(), "accumulator");
    expect_near(element_stiffness(body, e, view.x, Definiteness::none),
                reference["K_element"][static_cast<std::size_t>(e)].matrix(), "K_e");
  }
  EXPECT_NEAR(system.measure(state).elastic / reference["U"].number, 1, digits);
  const ForceCheck check = check_forces(system, state);
  expect_near(check.galerkin.reshaped(2, 4).transpose(), reference["f_total"].matrix(), "f");
  EXPECT_LT((check.ritz.reshaped(2, 4).transpose() - reference["minus_grad_U_central_difference_h1e_6"].matrix())
                .cwiseAbs()
                .maxCoeff(),
            5e-5);
  EXPECT_LT(check.difference, 5e-5);
  const ProductCheck product = check_product(system, state, reference["dx"].matrix().transpose().reshaped());
  expect_near(product.by_elements.reshaped(2, 4).transpose(), reference["df_matrix_free"].matrix(), "df");
  expect_near(product.by_matrix.reshaped(2, 4).transpose(), reference["df_assembled_K"].matrix(), "df");
  EXPECT_LT(product.difference, 1e-10);
}

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
