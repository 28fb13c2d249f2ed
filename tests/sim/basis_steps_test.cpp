// Bodies in a basis, stepped: what the schemes keep, how long explicit steps may be, the same bits, several bodies and
// obstacles.
#include "sim/build/parts.h"
#include "sim/study/modes.h"
#include "sim/time/scheme.h"
#include "tests/sim/allocations.h"
#include "tests/sim/basis_support.h"

namespace sim {
namespace {

using test::frames;
using test::loaded_block;
using test::plane_cantilever;
using test::reduced;
using test::rms;

int unknowns(const Scene& scene) {
  return System(scene).counts().free_dofs;
}

TEST(Basis, OfAllModesIsTheFullSystem) {
  for (const Scheme& scheme : schemes()) {
    Scene full = loaded_block(std::string(scheme.name));
    full.solver.tolerance = 1e-11;
    if (scheme.is_explicit()) full.time.substeps = 16;
    const Scene all = reduced(full, BasisKind::modes, unknowns(full));
    const Eigen::MatrixXd x = frames(full, 10), y = frames(all, 10);
    EXPECT_GT((x.col(10) - x.col(0)).cwiseAbs().maxCoeff(), 1e-4) << scheme.name;
    // One iteration, and a static step, leave what the solver of the full system leaves.
    const double close = scheme.one_iteration ? 1e-6 : 1e-9;
    EXPECT_LT((x - y).cwiseAbs().maxCoeff(), close) << scheme.name;
  }
}

// Backward Euler loses energy at every step, trapezoidal and the explicit schemes keep it: in a basis as without one.
TEST(Basis, EnergyIsThatOfTheScheme) {
  Scene scene = plane_cantilever(5e6, "backward-euler", 16, 4);
  const auto energies = [&](const std::string& integrator, int steps) {
    scene.time.integrator = integrator;
    scene.time.substeps = find_scheme(integrator)->is_explicit() ? 0 : 1;
    test::Stepped run(reduced(scene, BasisKind::derivatives, 9));
    std::vector<double> all;
    for (int k = 0; k < steps * run.system.steps_per_frame(); ++k) {
      const Measures m = run.system.measure(run.state);
      all.push_back(m.kinetic + m.elastic + m.potential);
      run.steps(1);
    }
    return all;
  };
  const double weight = 4 * 1000 * 9.81;  // N: the energy that a metre of fall sets free
  const std::vector<double> euler = energies("backward-euler", 60);
  for (std::size_t k = 1; k < euler.size(); ++k) EXPECT_LE(euler[k], euler[k - 1] + 1e-6 * weight);
  EXPECT_LT(euler.back(), -0.04 * weight);
  for (const char* integrator : {"trapezoidal", "implicit-midpoint", "central-difference"})
    for (const double energy : energies(integrator, 60)) EXPECT_NEAR(energy, 0, 0.02 * weight) << integrator;
}

TEST(Basis, ExplicitStepsAreAsLongAsItsFastestVectorAllows) {
  Scene full = plane_cantilever(5e6, "central-difference", 16, 4);
  full.time.substeps = 0;
  const Scene scene = reduced(full, BasisKind::modes, 4);
  const System system(scene);
  const double omega = vibration_modes(full, 0, 4).omega[3];
  // Power iterations may lack a little, which a twentieth of omega^2 makes up for.
  EXPECT_NEAR(system.stable_step() * omega / 2, 1, 0.03);
  EXPECT_GT(system.stable_step(), 5 * System(full).stable_step());
  test::Stepped run(scene);
  run.steps(60);
}

// A square falls onto the edge that holds it: what is pressed together is far stiffer, in a basis as without one.
Scene pressed_square(const char* integrator) {
  Scene scene = plane_cantilever(2e4, integrator, 4, 4);
  scene.bodies[0].mesh = generate_rectangle({1, 1}, {4, 4}, {1, 1}, ElementKind::tri3);
  scene.bodies[0].materials = {MaterialSpec{"neo-hookean", 2e4, 0.3, 1000, ""}};
  scene.probes.clear();
  scene.world.gravity = {-14, 0, 0};
  scene.time.fps = 1;
  scene.time.substeps = 0;
  return reduced(scene, BasisKind::modes, 20);
}

TEST(Basis, ExplicitStepsArePartedWhereTheBodyStiffens) {
  for (const char* integrator : {"symplectic-euler", "central-difference"}) {
    Scene scene = pressed_square(integrator);
    test::Stepped run(scene);
    EXPECT_GE(run.most_parts(10), 2) << integrator;
    EXPECT_GT(run.last.min_J, 0.3) << integrator;
    EXPECT_EQ(run.state.fastest.size(), 20) << "of the coordinates";
    // The same steps do not hold where they are not watched.
    scene.time.substeps = run.system.steps_per_frame();
    test::Stepped unwatched(scene);
    std::string failure;
    for (int k = 0; k < 10 * run.system.steps_per_frame() && failure.empty(); ++k)
      failure = unwatched.stepper->step(unwatched.state).failure;
    EXPECT_NE(failure, "") << integrator;
  }
}

Eigen::VectorXd bits(const State& state) {
  Eigen::VectorXd all(state.x.size() + state.v.size());
  all << state.x, state.v;
  return all;
}

TEST(SameBits, OfABasisForAnyNumberOfThreads) {
  for (const char* integrator : {"bdf2", "central-difference"}) {
    Scene scene = loaded_block(integrator);
    scene.bodies[0].mesh = generate_box({2, 1, 1}, {12, 6, 6}, {1, 1, 1}, ElementKind::tet4);
    scene.bodies[0].materials.resize(1);
    scene.time.substeps = 8;
    scene = reduced(scene, BasisKind::derivatives, 9);
    test::Stepped one(scene, 1), two(scene, 2), four(scene, 4);
    for (test::Stepped* run : {&one, &two, &four}) run->steps(6);
    EXPECT_EQ(hash(one.state), hash(two.state));
    EXPECT_EQ(hash(one.state), hash(four.state));
  }
}

TEST(SameBits, OfABasisWhenAStateIsGoneOnWith) {
  for (const char* integrator : {"trapezoidal", "bdf2", "tr-bdf2", "central-difference"}) {
    Scene scene = loaded_block(integrator);
    scene.time.substeps = 8;
    scene = reduced(scene, BasisKind::derivatives, 9);
    test::Stepped through(scene), first(scene), then(scene);
    through.steps(8);
    first.steps(5);
    then.state = first.state;
    then.steps(3);
    EXPECT_EQ(hash(through.state), hash(then.state)) << integrator;
    // Without coordinates they are found from the nodes, to round-off.
    first.state.coordinates = {};
    first.steps(3);
    EXPECT_LT((bits(first.state) - bits(through.state)).cwiseAbs().maxCoeff(), 1e-4) << integrator;
  }
}

TEST(SameBits, OfABasisWhoseStepsAreWatched) {
  const Scene scene = pressed_square("central-difference");
  for (const int saved_at : {5, 16, 37}) {
    test::Stepped straight(scene), resumed(scene, 2);
    straight.steps(saved_at);
    resumed.state = straight.state;
    straight.steps(60);
    resumed.steps(60);
    EXPECT_EQ(hash(straight.state), hash(resumed.state)) << saved_at;
  }
}

TEST(Allocations, NoneInAStepInABasis) {
  if (!test::can_count_allocations()) GTEST_SKIP() << "the sanitizer has malloc";
  for (const char* integrator : {"backward-euler", "tr-bdf2", "symplectic-euler"}) {
    Scene scene = loaded_block(integrator);
    scene.time.substeps = 8;
    test::Stepped run(reduced(scene, BasisKind::derivatives, 9));
    run.steps(3);
    test::start_counting();
    run.stepper->step(run.state);
    EXPECT_EQ(test::stop_counting(), 0) << integrator;
  }
}

// Two bodies, each with a basis of its own, move as each would alone.
TEST(Basis, SeveralBodiesMoveAsTheyWouldAlone) {
  Scene one = plane_cantilever(5e6, "trapezoidal", 12, 3), other = plane_cantilever(1e6, "trapezoidal", 8, 2),
        both = one;
  other.bodies[0].name = "other";
  other.probes[0].body = "other";
  other.bodies[0].mass = MassMatrix::consistent;
  both.bodies.push_back(other.bodies[0]);
  both = reduced(both, BasisKind::derivatives, 5);
  const Eigen::MatrixXd x = frames(reduced(one, BasisKind::derivatives, 5), 30),
                        y = frames(reduced(other, BasisKind::derivatives, 5), 30), all = frames(both, 30);
  EXPECT_LT((all.topRows(x.rows()) - x).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_LT((all.bottomRows(y.rows()) - y).cwiseAbs().maxCoeff(), 1e-7);
}

// A plane that stands still holds a beam in a basis as it holds one without.
TEST(Basis, ObstaclesAreNotPassed) {
  Scene full = plane_cantilever(1e6, "backward-euler", 16, 4);
  full.solver.tolerance = 1e-6;
  full.obstacles = {Obstacle{Plane{{0, -0.3, 0}, {0, 1, 0}}, 0.3, "floor"}};
  const Eigen::MatrixXd run = frames(full, 60), x = frames(reduced(full, BasisKind::derivatives, 20), 60);
  double lowest = 0;
  for (Eigen::Index i = 1; i < x.rows(); i += 2) lowest = std::min(lowest, x.row(i).minCoeff());
  EXPECT_GT(lowest, -0.3);
  EXPECT_LT(lowest, -0.29);
  EXPECT_LT(rms(full, x, run), 0.02);
}

}  // namespace
}  // namespace sim
