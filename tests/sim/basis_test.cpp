// The vectors of a basis, x = X + U c, and what a body in it is: against full ones, against reference numbers, and what
// is refused.
#include <Eigen/Eigenvalues>
#include <map>

#include "sim/build/parts.h"
#include "sim/solve/tangent_operator.h"
#include "sim/study/difference.h"
#include "sim/study/modes.h"
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

TEST(Basis, ForcesAndStiffnessOnCoordinatesAreDerivatives) {
  const System system(reduced(loaded_block("backward-euler"), BasisKind::derivatives, 7));
  const Model& model = parts_of(system).reduction->model;
  ASSERT_EQ(model.dofs(), 7);
  test::expect_derivatives(model, 0.015 * test::random_vector(7, 1, 5).cwiseProduct(model.node_size));
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
