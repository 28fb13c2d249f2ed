// The dynamic cantilever against its reference, and locking. (The static references are scenes: tests/app.)
#include <fstream>
#include <sstream>

#include "tests/sim/stepping.h"

namespace sim {
namespace {

// Tip displacement [m] at k/480 s: ux, uz. tests/data/reference/beam3d_dynamic_reference.csv
std::vector<std::array<double, 2>> reference_tip() {
  std::ifstream file(RITZ_SOURCE_DIR "/tests/data/reference/beam3d_dynamic_reference.csv");
  std::vector<std::array<double, 2>> tip;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::stringstream cells(line);
    double t, x, z;
    char comma;
    cells >> t >> comma >> x >> comma >> z;
    tip.push_back({x, z});
  }
  return tip;
}

TEST(Reference, DynamicCantileverWithinOnePerCentAtEveryFrame) {
  Scene scene = test::beam("tet10", 2);
  Body& body = scene.bodies[0];
  body.mesh = generate_box({4, 1, 1}, {10, 3, 3}, {1.6, 1, 1}, ElementKind::tet10);
  body.materials[0].model = "neo-hookean";
  body.mass = MassMatrix::consistent;
  scene.time.integrator = "sdirk2";
  const auto tip = reference_tip();
  ASSERT_GT(tip.size(), 600u);
  test::Stepped run(scene, 2);
  double worst = 0;
  for (int frame = 1; frame <= 74; ++frame) {  // to t = 1.233 s
    run.steps(1);
    const Vec3 u = run.tip();
    worst = std::max(worst, std::hypot(u.x() - tip[8 * frame][0], u.z() - tip[8 * frame][1]));
  }
  std::printf("largest error of the tip: %.3f %% of the length\n", 100 * worst / 4);
  EXPECT_LT(worst, 0.01 * 4);
}

double static_deflection(const char* element, std::array<int, 3> cells, double poisson) {
  Scene scene = test::beam(element, 1, 1e6, poisson);
  scene.bodies[0].mesh = generate_box({4, 1, 1}, cells, {1.6, 1, 1}, find_element(element)->kind);
  scene.time.integrator = "static";
  scene.solver.definiteness = Definiteness::none;
  scene.solver.tolerance = 1e-7;
  scene.solver.max_iterations = 200;
  test::Stepped run(scene, 2);
  run.steps(1);
  return run.tip().z();
}

TEST(Locking, QuadraticTetsBendWhereLinearOnesDoNot) {
  const double converged = static_deflection("tet10", {16, 5, 5}, 0.499);
  const double tet10 = static_deflection("tet10", {8, 3, 3}, 0.499),
               tet4 = static_deflection("tet4", {16, 4, 4}, 0.499);
  std::printf("static deflection at nu = 0.499: converged %.4f m, tet10 %.4f m (%.2f %%), tet4 %.4f m (%.1f %%)\n",
              converged, tet10, 100 * (tet10 / converged - 1), tet4, 100 * (tet4 / converged - 1));
  EXPECT_NEAR(tet10 / converged, 1, 0.02);
  EXPECT_LT(tet4 / converged, 0.9) << "linear tets no longer lock: take the warning back";
  const auto warned = [](const char* element) {
    const auto remarks = System(test::beam(element, 1, 1e6, 0.499)).remarks();
    return std::any_of(remarks.begin(), remarks.end(),
                       [](const std::string& remark) { return remark.find("lock") != std::string::npos; });
  };
  EXPECT_TRUE(warned("tet4"));
  EXPECT_FALSE(warned("tet10"));
}

// A ratio of 1e6 between two regions of one body: the stiff half stays straight, the soft one takes the bending.
TEST(Regions, AStiffnessRatioOfAMillion) {
  Scene scene = test::beam("tet10", 1, 1e5, 0.3);
  Body& body = scene.bodies[0];
  body.mesh = generate_box({4, 1, 1}, {8, 2, 2}, {1, 1, 1}, ElementKind::tet10);
  Group stiff{"stiff", {}, {}, {}};
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    double x = 0;
    for (int a = 0; a < 4; ++a) x += body.mesh.X(0, body.mesh.elements(a, e)) / 4;
    if (x > 2) stiff.elements.push_back(e);
  }
  body.mesh.groups.push_back(stiff);
  MaterialSpec hard = body.materials[0];
  hard.young = 1e11;
  hard.group = "stiff";
  body.materials.push_back(hard);
  scene.probes = {{"a", "beam", {2, 0.5, 0.5}}, {"b", "beam", {3, 0.5, 0.5}}, {"c", "beam", {4, 0.5, 0.5}}};
  test::Stepped run(scene);
  run.steps(20);
  const Vec3 a = run.system.probe_position(run.state, 0), b = run.system.probe_position(run.state, 1),
             c = run.system.probe_position(run.state, 2);
  EXPECT_LT((0.5 * (a + c) - b).norm(), 1e-5) << "the stiff half bends";
  EXPECT_NEAR((c - a).norm(), 2, 1e-5);
  EXPECT_LT(a.z() - 0.5, -0.05) << "the soft half does not";
}

}  // namespace
}  // namespace sim
