// Bodies that move in a basis, x = X + U c, against full ones, against reference numbers, and against themselves.
#include <Eigen/Eigenvalues>
#include <map>

#include "sim/build/parts.h"
#include "sim/solve/tangent_operator.h"
#include "sim/study/difference.h"
#include "sim/study/modes.h"
#include "sim/time/scheme.h"
#include "tests/sim/allocations.h"
#include "tests/sim/basis_support.h"
#include "tests/sim/json.h"

namespace sim {
namespace {

using test::frames;
using test::loaded_block;
using test::plane_cantilever;
using test::reduced;
using test::rms;
using test::with_snapshots;

const test::Json& reference_row(const test::Json& beam, const std::string& basis, int r) {
  for (const test::Json& row : beam["rows"].list)
    if (row["basis"].text == basis && row["r"].number == r) return row;
  throw std::runtime_error("no row " + basis);
}

const std::map<BasisKind, std::string> reference_name = {
    {BasisKind::modes, "linear modes"},
    {BasisKind::derivatives, "k modes and their k(k+1)/2 derivatives"},
    {BasisKind::snapshots, "POD of the same dynamic run"}};

class ReducedBeam : public ::testing::TestWithParam<std::string> {
 protected:
  const test::Json reference_ = test::lecture_data("reduced.json");
  const test::Json& beam_ = reference_[GetParam()];
  const double young_ = beam_["config"]["E"].number;
  const Scene moving_ = plane_cantilever(young_, "trapezoidal"), still_ = plane_cantilever(young_, "static");
};

TEST_P(ReducedBeam, HasTheErrorsOfTheReference) {
  constexpr int steps = 120;
  const Eigen::MatrixXd run = frames(moving_, steps), rest = frames(still_, 1);
  for (const auto& [kind, name] : reference_name)
    for (const int r : {5, 10, 20, 40}) {
      const test::Json& row = reference_row(beam_, name, r);
      const auto in_basis = [&](const Scene& scene) {
        return kind == BasisKind::snapshots ? with_snapshots(scene, run, r) : reduced(scene, kind, r);
      };
      const std::string what = name + " " + std::to_string(r);
      const double still = rms(moving_, frames(in_basis(still_), 1).col(1), rest.col(1));
      const double moving = rms(moving_, frames(in_basis(moving_), steps), run);
      EXPECT_NEAR(still / row["static_rms"].number, 1, 0.05) << what << ", static";
      EXPECT_NEAR(moving / row["dynamic_rms"].number, 1, 0.05) << what << ", dynamic";
    }
}
INSTANTIATE_TEST_SUITE_P(Basis, ReducedBeam, ::testing::Values("moderate", "large"),
                         [](const auto& info) { return info.param; });

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

TEST(Basis, ErrorsFallAsVectorsAreAdded) {
  const Scene full = plane_cantilever(5e6, "trapezoidal", 16, 4);
  const Eigen::MatrixXd run = frames(full, 60);
  double before = 1;
  for (const int r : {2, 5, 9, 14, 20}) {
    const double error = rms(full, frames(reduced(full, BasisKind::derivatives, r), 60), run);
    EXPECT_LT(error, 0.8 * before) << r;
    before = error;
  }
  EXPECT_LT(before, 2e-4);
  before = 1;
  for (const int r : {3, 8, 20}) {
    const double error = rms(full, frames(with_snapshots(full, run, r), 60), run);
    EXPECT_LT(error, 0.3 * before) << r;
    before = error;
  }
}

// U(c) of the reduced system, its forces and its stiffness: central differences of the one give the other.
TEST(Basis, ForcesAndStiffnessOnCoordinatesAreDerivatives) {
  const Scene scene = reduced(loaded_block("backward-euler"), BasisKind::derivatives, 7);
  const System system(scene);
  const Model& model = parts_of(system).reduction->model;
  const Eigen::Index r = model.dofs();
  ASSERT_EQ(r, 7);
  TangentOperator tangent(model, 1);
  tangent.free().setOnes();
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(r),
                        c = 0.3 * test::random_vector(r, 1, 5).cwiseQuotient(model.node_size.cwiseInverse());
  const Eigen::VectorXd x = 0.05 * c;
  tangent.begin_step({still, still, 0, 0});
  // Inside a stage v = (c - c*)/(g h); c* = 0 here.
  constexpr double rate = 60, t = 0.03, e = 1e-6;
  const auto at = [&](const Eigen::VectorXd& q, const auto& ask) {
    const Eigen::VectorXd v = rate * q;
    return ask(Motion{q, v, t, rate});
  };
  Eigen::VectorXd f(r), g(r), p(r), Kp(r);
  at(x, [&](const Motion& motion) { tangent.linearise(motion, 0, Definiteness::none, f); });
  for (Eigen::Index k = 0; k < r; ++k) {
    const Eigen::VectorXd d = e * model.node_size[k] * Eigen::VectorXd::Unit(r, k);
    const auto energy = [&](const Motion& motion) { return tangent.energy(motion); };
    const double slope = (at(x + d, energy) - at(x - d, energy)) / (2 * d[k]);
    EXPECT_NEAR(-f[k], slope, 1e-6 * f.norm()) << k;
    p.setUnit(k);
    tangent.multiply(p, Kp);
    at(x + d, [&](const Motion& motion) { tangent.forces(motion, f); });
    at(x - d, [&](const Motion& motion) { tangent.forces(motion, g); });
    EXPECT_LT((Kp + (f - g) / (2 * d[k])).norm(), 1e-6 * Kp.norm()) << k;
    at(x, [&](const Motion& motion) { tangent.forces(motion, f); });
  }
}

// Under the load s K psi_1 the body comes to rest at X + s psi_1 + s^2/2 Phi_11 + O(s^3): what is left of the forces
// there falls with the third power of s, and with the second where Phi_11 is left out.
TEST(Basis, ModalDerivativesAreTheCurvatureOfEquilibria) {
  Scene scene = loaded_block("backward-euler");
  Body& body = scene.bodies[0];
  body.loads = {};
  body.damping = {};
  scene.springs.clear();
  scene.world.gravity.setZero();
  const Eigen::MatrixXd psi = vibration_modes(scene, 0, 2).shape, Phi = modal_derivatives(scene, 0, psi);
  ASSERT_EQ(Phi.cols(), 3);
  const System system(scene);
  const Model& model = parts_of(system).model;
  TangentOperator tangent(model, 1);
  model.pins.mark(0, tangent.free());
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(model.dofs());
  Eigen::VectorXd f(model.dofs()), K_psi(model.dofs());
  const auto left = [&](double s, double t, double with) {
    const Eigen::VectorXd mode = s * psi.col(0) + t * psi.col(1);
    const Eigen::VectorXd bent = 0.5 * s * s * Phi.col(0) + s * t * Phi.col(1) + 0.5 * t * t * Phi.col(2);
    tangent.begin_step({model.X, still, 0, 0});
    tangent.linearise({model.X, still, 0, 0}, 0, Definiteness::none, f);
    tangent.multiply(mode, K_psi);
    const Eigen::VectorXd x = model.X + mode + with * bent;
    tangent.forces({x, still, 0, 0}, f);
    return (f.cwiseProduct(tangent.free()) + K_psi).norm();
  };
  for (const auto& [s, t] : {std::pair{0.4, 0.0}, {0.0, 0.3}, {0.4, -0.3}}) {
    EXPECT_NEAR(left(s, t, 1) / left(s / 2, t / 2, 1), 8, 0.8);
    EXPECT_NEAR(left(s, t, 0) / left(s / 2, t / 2, 0), 4, 0.4);
  }
}

TEST(Basis, VectorsAreOrthonormalInTheMassAndZeroWherePinned) {
  for (const MassMatrix mass : {MassMatrix::lumped, MassMatrix::consistent}) {
    Scene scene = loaded_block("backward-euler");
    scene.bodies[0].mass = mass;
    scene = reduced(scene, BasisKind::derivatives, 12);
    const System system(scene);
    const Eigen::MatrixXd& U = scene.bodies[0].basis->vectors->U;
    const Eigen::MatrixXd gram = U.transpose() * parts_of(system).reduction->mass;
    EXPECT_LT((gram - Eigen::MatrixXd::Identity(12, 12)).cwiseAbs().maxCoeff(), 1e-12);
    for (const int node : system.pinned_nodes(0)) EXPECT_EQ(U.middleRows(3 * node, 3).norm(), 0);
    EXPECT_EQ(scene.bodies[0].basis->vectors->modes, 4) << "4 modes have 10 derivatives, 3 have 6";
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

// A ball of the basis' own: what starts outside of it starts where it is nearest.
TEST(Basis, AStartIsTakenIntoTheBasis) {
  Scene scene = plane_cantilever(1e6, "backward-euler", 16, 4);
  scene.bodies[0].velocity = {0, 1, 0};
  const Scene in_basis = reduced(scene, BasisKind::modes, 6);
  const System system(in_basis);
  const State state = system.initial_state();
  const Reduction& reduction = *parts_of(system).reduction;
  const State full = System(scene).initial_state();
  ASSERT_EQ(state.coordinates.rate.size(), 6);
  // What is left out is orthogonal to the basis in the mass.
  const Eigen::VectorXd left = reduction.mass.transpose() * (full.v - state.v);
  EXPECT_LT(left.norm(), 1e-10 * state.coordinates.rate.norm());
  EXPECT_GT(state.coordinates.rate.norm(), 0.9 * full.v.norm() * std::sqrt(1000 * 4.0 / (17 * 5)) * 0.9);
}

std::string refusal(const Scene& scene) {
  try {
    const System system(with_bases_made(scene));
  } catch (const InputError& error) {
    return error.key + ": " + error.what();
  }
  return "none";
}

TEST(Basis, IsRefusedWhereItCannotFollow) {
  const auto changed = [](const auto& change) {
    Scene scene = plane_cantilever(1e6, "backward-euler", 8, 2);
    scene.bodies[0].basis.emplace();
    scene.bodies[0].basis->count = 5;
    change(scene);
    return refusal(scene);
  };
  const auto says = [](const std::string& text, const std::string& what) {
    return text.find(what) != std::string::npos;
  };
  EXPECT_EQ(changed([](Scene&) {}), "none");
  EXPECT_PRED2(says, changed([](Scene& s) { s.bodies[0].pins.clear(); }),
               "body.0.basis: nothing holds \"beam\" (3 rigid");
  EXPECT_PRED2(says, changed([](Scene& s) { s.bodies[0].pins[0].axes = "x"; }), "(1 rigid motions");
  EXPECT_PRED2(says, changed([](Scene& s) { s.bodies[0].pins[0].release = 1; }), "body.0.pin.0.release");
  EXPECT_PRED2(says, changed([](Scene& s) { s.bodies[0].pins[0].motion.resize(1); }), "body.0.pin.0.motion");
  EXPECT_PRED2(says, changed([](Scene& s) { s.bodies[0].untangle = 1; }), "body.0.untangle");
  EXPECT_PRED2(says, changed([](Scene& s) { s.bodies[0].basis->count = 1000; }), "body.0.basis.count");
  EXPECT_PRED2(says, changed([](Scene& s) { s.bodies[0].basis->kind = BasisKind::snapshots; }), "body.0.basis.from");
  EXPECT_PRED2(says, changed([](Scene& s) {
                 s.bodies.push_back(s.bodies[0]);
                 s.bodies[1].name = "other";
                 s.bodies[1].basis.reset();
               }),
               "body.1: has no basis");
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

// A scene without a basis has no reduction, and its state no coordinates.
TEST(Basis, IsNotConstructedWhereNoneIsNamed) {
  test::Stepped run(plane_cantilever(1e6, "backward-euler", 8, 2));
  EXPECT_EQ(parts_of(run.system).reduction, nullptr);
  run.steps(1);
  EXPECT_EQ(run.state.coordinates.c.size(), 0);
  for (const TermInfo& term : run.system.terms()) EXPECT_EQ(term.name.find("basis"), std::string::npos);
}

}  // namespace
}  // namespace sim
