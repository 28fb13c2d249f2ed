// What the pages of the lecture on elements and forces show, against numbers that another program computed.
#include "sim/build/parts.h"
#include "sim/study/element_view.h"
#include "sim/study/force_check.h"
#include "sim/study/shape_functions.h"
#include "tests/sim/lecture_support.h"

namespace sim {
namespace {

using test::digits, test::expect_near, test::Json, test::lecture_data, test::single;

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

}  // namespace
}  // namespace sim
