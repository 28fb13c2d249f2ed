// Few elements that stand for all: the weights, what they are trained on, and what a body makes of them.
#include "sim/study/cubature.h"

#include "sim/build/parts.h"
#include "sim/linear/nonnegative.h"
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

const Cubature& cubature(const Scene& scene) {
  return *scene.bodies[0].basis->vectors->cubature;
}

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, double shift) {
  Eigen::MatrixXd G = test::random_vector(rows * columns, 1, 11).reshaped(rows, columns);
  G.array() += shift;
  return G;
}

TEST(FewWeights, FindTheColumnsThatTheSumIsMadeOf) {
  const Eigen::MatrixXd G = random_matrix(60, 200, 0.3);
  Eigen::VectorXd w = Eigen::VectorXd::Zero(200);
  for (const int k : {3, 50, 51, 120, 199}) w[k] = 1 + 0.1 * k;
  const FewWeights few = few_nonnegative(G, G * w, 1e-10);
  EXPECT_EQ(few.columns, (std::vector<int>{3, 50, 51, 120, 199}));
  for (std::size_t k = 0; k < few.weights.size(); ++k) EXPECT_NEAR(few.weights[k], w[few.columns[k]], 1e-7);
}

// Where the sum cannot be reached, what is left is as small as it gets with weights >= 0: no slope along a column that
// has one, and none upwards along another (Kuhn and Tucker).
TEST(FewWeights, EndWhereNoColumnHelps) {
  const Eigen::MatrixXd G = random_matrix(80, 40, 0.2);
  const Eigen::VectorXd b = test::random_vector(80, 1, 5);
  const FewWeights few = few_nonnegative(G, b, 0);
  ASSERT_FALSE(few.columns.empty());
  ASSERT_LT(few.columns.size(), 40u);
  Eigen::VectorXd r = b;
  for (std::size_t k = 0; k < few.columns.size(); ++k) {
    EXPECT_GT(few.weights[k], 0);
    r -= few.weights[k] * G.col(few.columns[k]);
  }
  EXPECT_NEAR(r.norm() / b.norm(), few.error, 1e-12);
  const Eigen::VectorXd slope = G.transpose() * r;
  EXPECT_LT(slope.maxCoeff(), 1e-9);
  for (const int column : few.columns) EXPECT_NEAR(slope[column], 0, 1e-9);
}

// All elements with weight 1 are the whole body.
TEST(Cubature, ForcesOfAllElementsAddUpToThoseOfTheBody) {
  const Scene scene = reduced(loaded_block("backward-euler"), BasisKind::derivatives, 6);
  const System system(scene);
  const Parts& parts = parts_of(system);
  const Eigen::MatrixXd c = 0.05 * test::random_vector(18, 1, 3).reshaped(6, 3);
  std::vector<int> all(static_cast<std::size_t>(scene.bodies[0].mesh.element_count()));
  for (std::size_t e = 0; e < all.size(); ++e) all[e] = static_cast<int>(e);
  const Eigen::VectorXd sums = element_forces(scene, 0, all, c).rowwise().sum();
  for (Eigen::Index k = 0; k < 3; ++k) {
    Eigen::VectorXd x, f, still;
    parts.reduction->lift->place(c.col(k), x);
    still = f = Eigen::VectorXd::Zero(x.size());
    for (const ElasticPart& part : parts.model.elastic)
      part.term->add_forces({x, still, 0, 0}, *part.term->make_store(1), f);
    Eigen::VectorXd g = Eigen::VectorXd::Zero(6);
    parts.reduction->lift->gather(f, g);
    EXPECT_LT((sums.segment(6 * k, 6) - g).norm(), 1e-12 * g.norm()) << k;
  }
}

TEST(Cubature, KeepsTheErrorThatIsAskedFor) {
  const Scene full = plane_cantilever(1e6, "backward-euler");
  std::size_t before = 0;
  for (const double tolerance : {0.1, 0.03, 0.01}) {
    const Scene scene = reduced(full, BasisKind::derivatives, 9, tolerance);
    const Cubature& chosen = cubature(scene);
    EXPECT_LE(chosen.error, tolerance);
    EXPECT_GT(chosen.states, 40);
    EXPECT_GT(chosen.elements.size(), before) << "a smaller error takes more elements";
    EXPECT_LT(chosen.elements.size(), 128u) << "of 512";
    EXPECT_TRUE(std::is_sorted(chosen.elements.begin(), chosen.elements.end()));
    for (const double weight : chosen.weights) EXPECT_GT(weight, 0);
    before = chosen.elements.size();
  }
}

// tests/data/lecture/reduced.json: trained on every fifth frame of the run.
TEST(Cubature, OfARunIsAsGoodAsTheReference) {
  const test::Json reference = test::lecture_data("reduced.json");
  const Scene full = plane_cantilever(1e6, "trapezoidal");
  const Eigen::MatrixXd run = frames(full, 120);
  for (const auto& [row, count] : {std::pair{0, 10}, std::pair{1, 20}}) {
    const test::Json& expected = reference["cubature"]["rows"][static_cast<std::size_t>(row)];
    Scene scene = test::with_snapshots(full, run, count);
    Basis& basis = *scene.bodies[0].basis;
    Eigen::MatrixXd fifth(run.rows(), 24);
    for (Eigen::Index k = 0; k < 24; ++k) fifth.col(k) = run.col(5 * k + 5) - run.col(0);
    basis.snapshots = std::make_shared<const Eigen::MatrixXd>(fifth);
    basis.cubature = 0.01;
    scene = with_bases_made(scene);
    EXPECT_NEAR(static_cast<double>(cubature(scene).elements.size()) / expected["elements"].number, 1, 0.2);
    EXPECT_LT(rms(full, frames(scene, 120), run), 2 * expected["dynamic_rms"].number);
  }
}

// Trained on what the body itself does, a basis with it is little worse than one with all elements.
TEST(Cubature, MovesTheBodyAsAllElementsDo) {
  const Scene full = plane_cantilever(1e6, "trapezoidal");
  const Eigen::MatrixXd run = frames(full, 60), all = frames(reduced(full, BasisKind::derivatives, 14), 60),
                        few = frames(reduced(full, BasisKind::derivatives, 14, 0.01), 60);
  const double error = rms(full, all, run);
  EXPECT_LT(rms(full, few, all), 0.2 * error);
  EXPECT_LT(rms(full, few, run), 1.2 * error);
}

TEST(Cubature, TakesAsManyElementsOnAFineMesh) {
  const auto elements = [](int n) {
    Scene scene = test::beam("tet4", n);
    return static_cast<double>(cubature(reduced(scene, BasisKind::derivatives, 9, 0.02)).elements.size());
  };
  const double coarse = elements(2), fine = elements(5);
  EXPECT_LT(fine, 1.5 * coarse);
}

// U(c), its forces and its stiffness belong together as with all elements: a step finds its minimum.
TEST(Cubature, ForcesAndStiffnessAreDerivativesOfItsEnergy) {
  const System system(reduced(loaded_block("backward-euler"), BasisKind::derivatives, 6, 0.05));
  const Model& model = parts_of(system).reduction->model;
  test::expect_derivatives(model, 0.03 * test::random_vector(6, 1, 9).cwiseProduct(model.node_size));
}

TEST(Cubature, HasTheSameBitsForAnyThreadsAndWhenGoneOnWith) {
  const Scene scene = reduced(loaded_block("bdf2"), BasisKind::derivatives, 6, 0.02);
  const Scene again = reduced(loaded_block("bdf2"), BasisKind::derivatives, 6, 0.02, 4);
  EXPECT_EQ(cubature(scene).elements, cubature(again).elements);
  EXPECT_EQ(cubature(scene).weights, cubature(again).weights);
  test::Stepped one(scene, 1), four(again, 4), then(scene, 2);
  one.steps(4);
  then.state = one.state;
  one.steps(4);
  then.steps(4);
  four.steps(8);
  EXPECT_EQ(hash(one.state), hash(four.state));
  EXPECT_EQ(hash(one.state), hash(then.state));
}

// Nothing but its own elements and the nodes of springs is touched in a step.
TEST(Cubature, StepsTouchNothingOfTheMesh) {
  Scene scene = reduced(loaded_block("backward-euler"), BasisKind::derivatives, 6, 0.05);
  scene.bodies[0].loads.pressures.clear();
  const System system(scene);
  const Reduction& reduction = *parts_of(system).reduction;
  ASSERT_TRUE(reduction.sample);
  EXPECT_EQ(reduction.sample->lift->dofs(), 3 * 4 * std::ssize(cubature(scene).elements));
  // Dead loads: weight, traction, force. Damping of the coordinates, the elements with theirs, a spring.
  EXPECT_EQ(reduction.model.terms.size(), 6u);
  test::Stepped run(scene);
  run.steps(3);
  EXPECT_GT(run.last.min_J, 0.5);
  if (!test::can_count_allocations()) return;
  test::start_counting();
  run.stepper->step(run.state);
  EXPECT_EQ(test::stop_counting(), 0);
}

}  // namespace
}  // namespace sim
