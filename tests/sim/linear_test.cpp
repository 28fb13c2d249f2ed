// The linear systems of sim/linear/: the matrix in single precision against the one in double, the solution against a
// dense one.
#include "tests/sim/linear_support.h"

namespace sim {
namespace {

using test::Bent, test::dense, test::float_matrix, test::for_each_case, test::random_vector;

TEST(FloatMatrix, IsTheMatrixToItsRoundOff) {
  for_each_case([]<int D>(const Bent& body) {
    const Eigen::MatrixXd A = body.dense(), F = dense(float_matrix<D>(body));
    EXPECT_LE((F - A).cwiseAbs().maxCoeff(), 1.3e-7 * A.cwiseAbs().maxCoeff());
    // Where a component is not free its row and its column are zero; elsewhere it is as symmetric as A is.
    for (Eigen::Index i = 0; i < A.rows(); ++i)
      if (body.ordered(body.free)[i] == 0) {
        EXPECT_EQ(F.row(i).norm() + F.col(i).norm(), 0);
      }
    EXPECT_LE((F - F.transpose()).cwiseAbs().maxCoeff(), 1e-13 * A.cwiseAbs().maxCoeff());
  });
}

// Pairs that no element couples, as contact has them; here a stiff spring between far nodes.
void add_springs(Bent& body) {
  const int D = body.model.D, last = body.model.node_count - 1;
  const auto values = body.A.values();
  std::vector<NodePair> pairs = {{0, last}, {2, last}, {0, last - 1}};
  body.A.set_zero(pairs);
  body.A.values() = values;
  const double stiffness = 100 * values[0];
  for (const NodePair& pair : body.A.outside())
    for (int c = 0; c < D; ++c) {
      body.A.find(pair.i, pair.j)[c * D + c] -= stiffness;
      for (const int node : {pair.i, pair.j}) body.A.find(node, node)[c * D + c] += stiffness;
    }
}

TEST(FloatMatrix, HasBlocksOutsideOfThePattern) {
  Bent body({"tet4", false}, 3, 1e3, 12, true);
  add_springs(body);
  ASSERT_EQ(body.A.outside().size(), 3u);
  const Eigen::MatrixXd A = body.dense(), F = dense(float_matrix<3>(body));
  EXPECT_LE((F - A).cwiseAbs().maxCoeff(), 1.3e-7 * A.cwiseAbs().maxCoeff());
}

TEST(TwoLevel, SolvesWithBlocksOutsideOfThePattern) {
  for (const bool coarse : {false, true}) {
    Bent body({"tet4", false}, 5, 1, 24, true);
    const std::unique_ptr<BlockSystem> system =
        make_block_system(*body.model.pattern, body.model.X, 3, body.first_node);
    system->restrict_to(body.free);
    Eigen::VectorXd x(body.x.size());
    const Eigen::VectorXd b = body.free.cwiseProduct(random_vector(x.size(), 1, 4));
    int iterations[2];
    for (const bool springs : {false, true}) {
      if (springs) add_springs(body);
      system->take(body.A, 1);
      if (coarse) {
        ASSERT_TRUE(system->make_coarse(body.x, 1));
      }
      const PcgResult result = system->solve(b, 1e-6, 1000, 1, x);
      EXPECT_TRUE(result.converged);
      iterations[springs] = result.iterations;
      EXPECT_LE((body.dense() * body.ordered(x) - body.ordered(b)).norm(), 1e-5 * b.norm());
    }
    // Nodes that the springs hold together are one block of the preconditioner.
    EXPECT_LE(iterations[1], 1.2 * iterations[0] + 3);
  }
}

// Rounding alone would leave 6e-8 of |A| in the sums of the rows, which stand for the mass and for what holds the body.
TEST(FloatMatrix, SumsOfRowsAreExact) {
  for (const test::Kind& kind : {test::Kind{"tet4", false}, test::Kind{"tri3", false}}) {
    const Bent body(kind, 4, 1e-3, 20);
    const auto check = [&]<int D>(const FloatMatrix<D>& F) {
      const Eigen::MatrixXd A = body.dense(), B = dense(F);
      for (int c = 0; c < D; ++c) {
        Eigen::VectorXd move = Eigen::VectorXd::Zero(A.rows());
        for (Eigen::Index i = c; i < move.size(); i += D) move[i] = 1;
        EXPECT_NEAR(move.dot(B * move), move.dot(A * move), 1e-13 * A.cwiseAbs().sum());
      }
    };
    if (body.model.D == 2)
      check(float_matrix<2>(body));
    else
      check(float_matrix<3>(body));
  }
}

TEST(FloatMatrix, ScalesStayWithinFloat) {
  for (const double size : {1e-25, 1e25}) {
    Bent body({"tet4", false}, 3, 1e3, 12);
    for (double& value : body.A.values()) value *= size;
    const Eigen::MatrixXd A = body.dense(), F = dense(float_matrix<3>(body));
    EXPECT_LE((F - A).cwiseAbs().maxCoeff(), 1.3e-7 * A.cwiseAbs().maxCoeff()) << size;
  }
}

TEST(FloatMatrix, InverseBlocksInvert) {
  for_each_case([]<int D>(const Bent& body) {
    const FloatMatrix<D> F = float_matrix<D>(body);
    const Eigen::MatrixXd A = body.dense();
    for (int i = 0; i < F.rows(); ++i) {
      Eigen::Matrix<double, D, D> own = F.scale() * A.block<D, D>(i * D, i * D);
      for (int c = 0; c < D; ++c)
        if (own(c, c) == 0) own(c, c) = 1;
      EXPECT_LE((own * F.inverse(i).template cast<double>() - Eigen::Matrix<double, D, D>::Identity()).norm(), 1e-5);
    }
  });
}

class Solution : public ::testing::Test {
 protected:
  PcgResult solve(const Bent& body, double tolerance, bool coarse, int threads, Eigen::VectorXd& x) {
    const auto system = make_block_system(*body.model.pattern, body.model.X, body.model.D, body.first_node);
    system->restrict_to(body.free);
    system->take(body.A, threads);
    if (coarse) {
      EXPECT_TRUE(system->make_coarse(body.x, threads));
    }
    x.resize(body.x.size());
    return system->solve(b(body), tolerance, 2000, threads, x);
  }
  Eigen::VectorXd b(const Bent& body) { return random_vector(body.x.size(), 1, 6).cwiseProduct(body.free); }
};

TEST_F(Solution, IsThatOfTheMatrix) {
  for_each_case([this]<int D>(const Bent& body) {
    for (const bool coarse : {false, true}) {
      Eigen::VectorXd x;
      EXPECT_TRUE(solve(body, 1e-9, coarse, 1, x).converged);
      Eigen::VectorXd Ax(x.size());
      body.A.multiply(x, Ax, 1);
      EXPECT_EQ(x.cwiseProduct(Eigen::VectorXd::Ones(x.size()) - body.free).norm(), 0);
      EXPECT_LE((Ax.cwiseProduct(body.free) - b(body)).norm(), 1e-5 * b(body).norm());
    }
  });
}

TEST_F(Solution, HasTheSameBitsForAnyNumberOfThreads) {
  const Bent body({"tet4", false}, 9, 1, 64);
  Eigen::VectorXd one, other;
  const PcgResult result = solve(body, 1e-8, true, 1, one);
  for (const int threads : {2, 4}) {
    EXPECT_EQ(solve(body, 1e-8, true, threads, other).iterations, result.iterations);
    EXPECT_TRUE(one == other) << threads;
  }
}

// A body that hardly anything holds: the coarse level knows how it moves as a whole and how it bends.
TEST_F(Solution, TakesFewIterationsWithTheCoarseLevel) {
  const Bent body({"tet4", false}, 12, 1e-3, 64);
  Eigen::VectorXd x;
  const int without = solve(body, 1e-2, false, 1, x).iterations, with = solve(body, 1e-2, true, 1, x).iterations;
  EXPECT_LT(2 * with, without);
}

TEST_F(Solution, NegativeCurvatureIsSeen) {
  Bent body({"tet4", false}, 4, 1e3, 64);
  const auto system = make_block_system(*body.model.pattern, body.model.X, body.model.D, body.first_node);
  system->take(body.A, 1);
  ASSERT_TRUE(system->make_coarse(body.x, 1));
  for (double& value : body.A.values()) value = -value;
  system->take(body.A, 1);
  Eigen::VectorXd x(body.x.size());
  EXPECT_FALSE(system->solve(b(body), 1e-6, 100, 1, x).positive_definite);
  EXPECT_FALSE(system->make_coarse(body.x, 1));
}

}  // namespace
}  // namespace sim
