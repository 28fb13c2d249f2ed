// Vibration modes: eigenvalues of the program's own K and M at rest, against references and against each other.
#include <numbers>

#include "sim/build/parts.h"
#include "sim/mesh/refine.h"
#include "sim/study/explicit_limit.h"
#include "sim/study/modes.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

Eigen::VectorXd frequencies(const Scene& scene, int count) {
  return vibration_modes(scene, 0, count).omega / (2 * std::numbers::pi);
}

// tests/data/reference/beam3d_frequencies_nu0.3.csv, finest rows; 1e-4.
TEST(Frequencies, OfTheCantileverWithinHalfAPerCent) {
  const double reference[] = {0.30792, 0.30792, 1.13023, 1.55922, 1.55922, 1.98902};
  Scene scene = test::beam("tet10", 2, 1e6, 0.3);
  scene.bodies[0].mesh = generate_box({4, 1, 1}, {12, 4, 4}, {1.6, 1, 1}, ElementKind::tet10);
  scene.bodies[0].mass = MassMatrix::consistent;
  const Eigen::VectorXd found = frequencies(scene, 6);
  ASSERT_EQ(found.size(), 6);
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(found[k] / reference[k], 1, 0.005) << "frequency " << k + 1;
}

// Ritz: with consistent mass every frequency is an upper bound, and refining brings it down.
TEST(Frequencies, AreUpperBoundsThatRefiningLowers) {
  const double reference[] = {0.30792, 0.30792, 1.13023, 1.55922, 1.55922, 1.98902};
  Scene scene = test::beam("tet4", 2, 1e6, 0.3);
  scene.bodies[0].mass = MassMatrix::consistent;
  const Eigen::VectorXd coarse = frequencies(scene, 6);
  scene.bodies[0].mesh = refine(scene.bodies[0].mesh);
  const Eigen::VectorXd fine = frequencies(scene, 6);
  for (int k = 0; k < 6; ++k) {
    EXPECT_LT(fine[k], coarse[k]);
    EXPECT_GT(fine[k], reference[k] * (1 - 1e-4));
  }
  EXPECT_GT(coarse[0], 1.05 * reference[0]) << "linear tets this coarse are too stiff";
}

Scene plane_beam(ElementKind kind, int nx, int ny, double young) {
  Scene scene;
  scene.dimension = 2;
  Body body;
  body.mesh = generate_rectangle({4, 1}, {nx, ny}, {1, 1}, kind);
  body.materials = {MaterialSpec{"stable-neo-hookean", young, 0.3, 1000, ""}};
  body.pins = {Pin{InGroup{"left"}, "xy", {}, {}}};
  scene.bodies = {body};
  return scene;
}

// tests/data/lecture/stability.json, to ten digits.
TEST(Frequencies, OfPlaneBeamsAreThoseOfTheReference) {
  struct Case {
    ElementKind kind;
    int nx, ny;
    double young;
    MassMatrix mass;
    double slowest, fastest;  // Hz, rad/s
  };
  for (const Case& c : {Case{ElementKind::tri3, 16, 4, 1e6, MassMatrix::lumped, 0.3415416076, 358.8659548},
                        Case{ElementKind::quad4, 16, 4, 1e6, MassMatrix::lumped, 0.3263946164, 297.1374516},
                        Case{ElementKind::quad4, 16, 4, 1e6, MassMatrix::consistent, 0.3272833505, 581.197299},
                        Case{ElementKind::tri3, 32, 8, 1e6, MassMatrix::lumped, 0.3260746099, 715.730679},
                        Case{ElementKind::tri3, 16, 4, 4e6, MassMatrix::consistent, 0.6849270985, 1414.385703}}) {
    Scene scene = plane_beam(c.kind, c.nx, c.ny, c.young);
    scene.bodies[0].mass = c.mass;
    EXPECT_NEAR(frequencies(scene, 2)[0] / c.slowest, 1, 1e-8);
    EXPECT_NEAR(fastest_frequency(scene, 0) / c.fastest, 1, 1e-8);
  }
}

TEST(Frequencies, ManyModesByOneSolverAndFewByTheOtherAreTheSame) {
  const Scene scene = plane_beam(ElementKind::quad4, 32, 8, 1e6);
  const Modes few = vibration_modes(scene, 0, 5), many = vibration_modes(scene, 0, 400);
  EXPECT_LT((few.omega - many.omega.head(5)).cwiseQuotient(few.omega).cwiseAbs().maxCoeff(), 1e-9);
  const double size = few.shape.cwiseAbs().maxCoeff();
  EXPECT_LT((few.shape - many.shape.leftCols(5)).cwiseAbs().maxCoeff(), 1e-6 * size);
}

// psi_i^T M psi_j = 1 or 0, and a free body has three rigid motions in the plane.
TEST(Frequencies, ModesAreOrthonormalAndRigidOnesCostNothing) {
  Scene scene = plane_beam(ElementKind::tri3, 16, 4, 1e6);
  scene.bodies[0].pins.clear();
  const Modes modes = vibration_modes(scene, 0, 8);
  const System system(scene);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(modes.omega[k], 0);
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      Eigen::VectorXd Mpsi = Eigen::VectorXd::Zero(modes.shape.rows());
      parts_of(system).model.masses[0].add_product(1, modes.shape.col(j), Mpsi, 2);
      EXPECT_NEAR(modes.shape.col(i).dot(Mpsi), i == j, 1e-6);
    }
}

TEST(Frequencies, ABodyThatIsPinnedWhollyHasNone) {
  Scene scene = plane_beam(ElementKind::tri3, 4, 2, 1e6);
  scene.bodies[0].pins = {Pin{Box{{-9, -9, -9}, {9, 9, 9}}, "xy", {}, {}, false}};
  EXPECT_EQ(vibration_modes(scene, 0, 5).omega.size(), 0);
  EXPECT_EQ(fastest_frequency(scene, 0), 0);
}

// A body that starts in a mode comes back after a period: x(t) = X + a psi cos(omega t), small.
TEST(Frequencies, ABodyThatStartsInAModeRingsWithItsFrequency) {
  Scene scene = plane_beam(ElementKind::quad4, 16, 4, 1e6);
  scene.world.gravity.setZero();
  scene.bodies[0].start.shape = "mode";
  scene.bodies[0].start.mode = 2;
  scene.bodies[0].start.amount = 1e-6;
  const double omega = vibration_modes(scene, 0, 2).omega[1];
  scene.time.integrator = "trapezoidal";
  scene.solver.tolerance = 1e-12;
  scene.time.fps = 400;
  const System system(with_modes_started(scene));
  State state = system.initial_state();
  const Eigen::VectorXd X = parts_of(system).model.X, start = state.x - X;
  EXPECT_NEAR(start.reshaped(2, start.size() / 2).colwise().norm().maxCoeff(), 1e-6, 1e-15);
  const auto stepper = make_stepper(system, 1);
  for (int k = 0; k < 100; ++k) ASSERT_EQ(stepper->step(state).failure, "");
  EXPECT_NEAR((state.x - X).dot(start) / start.squaredNorm(), std::cos(omega * system.time(100)), 2e-4);
  scene.bodies[0].start.mode = 100000;
  EXPECT_THROW(with_modes_started(scene), InputError);
}

// A static system weighs with consistent mass, but its limit is that of the mass that the scene names.
TEST(Frequencies, TheLimitOfAStaticSceneIsThatOfItsOwnMass) {
  Scene scene = plane_beam(ElementKind::quad4, 16, 4, 1e6);
  for (const auto& [mass, limit] :
       {std::pair{MassMatrix::lumped, 0.006730891677}, std::pair{MassMatrix::consistent, 0.00344117222}}) {
    scene.bodies[0].mass = mass;
    scene.time.integrator = "static";
    const double found = explicit_limit(scene, System(scene), 1);
    EXPECT_LE(found, limit);
    EXPECT_GE(found, 0.95 * limit);
    scene.time.integrator = "central-difference";
    EXPECT_EQ(explicit_limit(scene, System(scene), 1), found);
  }
}

}  // namespace
}  // namespace sim
