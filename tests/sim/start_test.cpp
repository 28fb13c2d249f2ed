#include "sim/body/start.h"

#include "sim/build/parts.h"
#include "sim/mesh/input_error.h"
#include "tests/sim/stepping.h"

namespace sim::test {
namespace {

const Kind tets{"tet4", false};

Scene started(const std::string& shape, const Kind& kind = tets) {
  Scene scene = free_body(kind, "stable-neo-hookean", 3);
  scene.bodies[0].start.shape = shape;
  return scene;
}

ElasticTerm::SmallestJ smallest_J(const System& system) {
  const ElasticTerm& term = *parts_of(system).model.elastic[0].term;
  return term.smallest_J(system.initial_state().x, *term.make_store(1));
}

TEST(Start, ShapesHaveTheJTheySay) {
  for (const Kind& kind : kinds) {
    if (kind.membrane) continue;
    EXPECT_NEAR(smallest_J(System(started("mirrored", kind))).J, -1, 1e-9) << kind.element;
    EXPECT_NEAR(smallest_J(System(started("stretched", kind))).J, 10, 1e-9) << kind.element;
    EXPECT_NEAR(smallest_J(System(started("squashed", kind))).J, 0.01, 1e-9) << kind.element;
    EXPECT_NEAR(smallest_J(System(started("far", kind))).J, 1, 1e-8) << kind.element;
    EXPECT_LT(smallest_J(System(started("scrambled", kind))).J, -0.1) << kind.element;
    EXPECT_LT(smallest_J(System(started("inverted", kind))).J, 0) << kind.element;
    EXPECT_NEAR(smallest_J(System(started("point", kind))).J, 0, 1e-3) << kind.element;
  }
  EXPECT_EQ(smallest_J(System(started("mirrored"))).inverted, 162);
}

TEST(Start, OneInvertedTetHasJMinusOne) {
  const System system(started("inverted"));
  EXPECT_LE(smallest_J(system).J, -1 + 1e-9);
  const State state = system.initial_state();
  int moved = 0;
  for (int i = 0; i < parts_of(system).model.node_count; ++i)
    moved += (state.x - parts_of(system).model.X).segment(3 * i, 3).norm() > 0;
  EXPECT_EQ(moved, 1);
}

TEST(Start, AmountDirectionAndPerturbationAreTaken) {
  Scene scene = started("stretched");
  scene.bodies[0].start.amount = 3;
  scene.bodies[0].start.direction = Vec3(0, 0, 1);
  const System system(scene);
  const Eigen::VectorXd x = system.initial_state().x, X = parts_of(system).model.X;
  const auto extent = [](const Eigen::VectorXd& v, int c) {
    const auto row = v.reshaped(3, v.size() / 3).row(c);
    return row.maxCoeff() - row.minCoeff();
  };
  EXPECT_NEAR(extent(x, 2), 3 * extent(X, 2), 1e-12);
  EXPECT_NEAR(extent(x, 0), extent(X, 0), 1e-12);
  scene.bodies[0].start = {};
  scene.bodies[0].start.perturbation = 0.01;
  const Eigen::VectorXd shaken = System(scene).initial_state().x - X;
  EXPECT_GT(shaken.cwiseAbs().maxCoeff(), 0.009 * 1.2);
  EXPECT_LE(shaken.cwiseAbs().maxCoeff(), 0.01 * 1.2);
}

TEST(Start, TheSeedSettlesEverythingRandom) {
  Scene scene = started("scrambled");
  const Eigen::VectorXd x = System(scene).initial_state().x;
  EXPECT_EQ(x, System(scene).initial_state().x);
  scene.seed = 2;
  EXPECT_NE(x, System(scene).initial_state().x);
  scene.bodies.push_back(scene.bodies[0]);  // each body has random numbers of its own
  const Eigen::VectorXd two = System(scene).initial_state().x;
  EXPECT_NE(two.head(x.size()), two.tail(x.size()));
}

// Where the energy is infinite there is no start: which element, and what to take instead.
TEST(Start, NeoHookeanRefusesAnInvertedStart) {
  Scene scene = started("mirrored");
  scene.bodies[0].materials[0].model = "neo-hookean";
  try {
    const System system(scene);
    FAIL() << "was built";
  } catch (const InputError& error) {
    EXPECT_EQ(error.key, "body.0.start");
    EXPECT_NE(std::string(error.what()).find("inverts 162 elements"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("stable-neo-hookean"), std::string::npos) << error.what();
  }
  scene.bodies[0].start.shape = "squashed";
  EXPECT_NO_THROW(System{scene});
}

TEST(Start, AnUnknownShapeIsRefused) {
  EXPECT_THROW(System{started("crumpled")}, InputError);
}

TEST(Start, AffineAndNodesPutNodesWhereTheySay) {
  Scene scene = started("affine", {"tri3", false});
  scene.bodies[0].start.matrix = {1, 0.2, 0, 0.8};
  const System sheared(scene);
  const Eigen::VectorXd x = sheared.initial_state().x, X = parts_of(sheared).model.X;
  for (Eigen::Index i = 0; i < X.size(); i += 2) {
    EXPECT_NEAR(x[i], X[i] + 0.2 * X[i + 1], 1e-15);
    EXPECT_NEAR(x[i + 1], 0.8 * X[i + 1], 1e-15);
  }
  EXPECT_NEAR(smallest_J(sheared).J, 0.8, 1e-12);
  Scene placed = started("nodes", {"tri3", false});
  for (Eigen::Index i = 0; i < x.size(); i += 2) placed.bodies[0].start.nodes.push_back({x[i], x[i + 1], 0});
  EXPECT_EQ(System(placed).initial_state().x, x);
  placed.bodies[0].start.nodes.pop_back();
  EXPECT_THROW(System{placed}, InputError);
  scene.bodies[0].start.matrix.clear();
  EXPECT_THROW(System{scene}, InputError);
}

}  // namespace
}  // namespace sim::test
