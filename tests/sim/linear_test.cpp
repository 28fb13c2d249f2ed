// The linear systems of sim/linear/: the matrix in single precision against the one in double, rigid modes against
// rigid motions, the coarse matrix against the dense product, the solution against a dense one.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "sim/linear/block_system.h"
#include "sim/linear/coarse_matrix.h"
#include "sim/solve/tangent_operator.h"
#include "tests/sim/scenes.h"

namespace sim {
namespace {

using test::random_vector;

// The matrix of a free body's Newton step where it is bent, and what stands around it.
struct Bent {
  System system;
  const Model& model;
  TangentOperator tangent;
  Eigen::VectorXd x, free;
  BlockMatrix A;
  std::vector<int> first_node;
  Aggregates aggregates;

  Bent(const test::Kind& kind, int cells, double mass, int size, bool pinned = false)
      : system(test::free_body(kind, "stable-neo-hookean", cells)),
        model(parts_of(system).model),
        tangent(model, 1),
        x(model.X + random_vector(model.dofs(), 0.05 / cells, 3)),
        free(Eigen::VectorXd::Ones(model.dofs())),
        A(*model.pattern, model.D),
        first_node({0, model.node_count}),
        aggregates(bisect(model.X, model.D, first_node, size)) {
    if (pinned)
      for (Eigen::Index i = 0; i < free.size(); i += 7) free[i] = 0;
    tangent.free() = free;
    Eigen::VectorXd f(model.dofs());
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(model.dofs());
    tangent.begin_step({x, still, 0, 0});
    tangent.linearise({x, still, 0, 0}, mass, Definiteness::clamp, f);
    tangent.assemble(A);
  }
  Eigen::VectorXd ordered(const Eigen::VectorXd& v) const {
    Eigen::VectorXd result(v.size());
    for (std::size_t k = 0; k < aggregates.order.size(); ++k)
      result.segment(k * model.D, model.D) = v.segment(aggregates.order[k] * model.D, model.D);
    return result;
  }
  // A on the free components, in the order of the aggregates.
  Eigen::MatrixXd dense() const {
    Eigen::MatrixXd result(x.size(), x.size());
    Eigen::VectorXd column(x.size());
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      A.multiply(Eigen::VectorXd::Unit(x.size(), k).cwiseProduct(free), column, 1);
      result.col(k) = ordered(column.cwiseProduct(free));
    }
    Eigen::MatrixXd turned = result.transpose();
    for (Eigen::Index k = 0; k < x.size(); ++k) result.col(k) = ordered(turned.col(k));
    return result;
  }
};

template <int D>
FloatMatrix<D> float_matrix(const Bent& body) {
  FloatMatrix<D> F(*body.model.pattern, body.aggregates.order);
  F.restrict_to(body.ordered(body.free));
  F.take(body.A, 1);
  return F;
}

template <int D>
Eigen::MatrixXd dense(const FloatMatrix<D>& F) {
  const Eigen::Index n = static_cast<Eigen::Index>(F.rows()) * D;
  Eigen::MatrixXd result(n, n);
  Eigen::VectorXd p(n + 1);
  for (Eigen::Index k = 0; k < n; ++k) {
    p.setZero();
    p[k] = 1;
    F.multiply(0, F.rows(), p.data(), result.col(k).data());
  }
  return result / F.scale();
}

template <int D>
Eigen::MatrixXd coarse_space(const Bent& body, const RigidModes<D>& modes) {
  constexpr int n = RigidModes<D>::count;
  const Eigen::VectorXd free = body.ordered(body.free);
  Eigen::MatrixXd Q = Eigen::MatrixXd::Zero(body.x.size(), body.aggregates.count() * n);
  for (int a = 0; a < body.aggregates.count(); ++a)
    for (int k = body.aggregates.start[a]; k < body.aggregates.start[a + 1]; ++k)
      Q.block<D, n>(k * D, a * n) = free.segment<D>(k * D).asDiagonal() * modes.motion(k) * modes.T(a);
  return Q;
}

template <class F>
void for_each_case(const F& f) {
  for (const test::Kind& kind : test::kinds)
    for (const bool pinned : {false, true}) {
      SCOPED_TRACE(std::string(kind.element) + (kind.membrane ? " membrane" : "") + (pinned ? " pinned" : ""));
      const Bent body(kind, 3, 1e3, 12, pinned);
      if (body.model.D == 2)
        f.template operator()<2>(body);
      else
        f.template operator()<3>(body);
    }
}

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
  const std::vector<double> values = body.A.values();
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

TEST(Aggregates, HoldEveryNodeOnceAndKeepBodiesApart) {
  const Eigen::VectorXd X = random_vector(3 * 1000, 1, 5);
  const std::vector<int> first_node = {0, 300, 300, 310, 1000};
  const Aggregates aggregates = bisect(X, 3, first_node, 40);
  std::vector<int> nodes = aggregates.order;
  std::sort(nodes.begin(), nodes.end());
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(nodes[i], i);
  EXPECT_EQ(aggregates.count(), 8 + 1 + 17);  // round(300/40), at least one, round(690/40)
  for (int a = 0; a < aggregates.count(); ++a) {
    const int first = aggregates.order[aggregates.start[a]], last = aggregates.order[aggregates.start[a + 1] - 1];
    const auto body = [&](int node) { return node < 300 ? 0 : node < 310 ? 1 : 2; };
    EXPECT_EQ(body(first), body(last));
    const int size = aggregates.start[a + 1] - aggregates.start[a];
    EXPECT_TRUE((size >= 36 && size <= 42) || body(first) == 1) << size;
  }
}

// A line of nodes is cut into pieces that do not overlap.
TEST(Aggregates, AreCompact) {
  Eigen::VectorXd X = Eigen::VectorXd::Zero(2 * 64);
  for (int i = 0; i < 64; ++i) X[2 * i] = (i * 37) % 64;
  const std::vector<int> first_node = {0, 64};
  const Aggregates aggregates = bisect(X, 2, first_node, 8);
  ASSERT_EQ(aggregates.count(), 8);
  for (int k = 0; k < 64; ++k) EXPECT_EQ(static_cast<int>(X[2 * aggregates.order[k]]) / 8, k / 8);
}

// Q reproduces any rigid motion of what is free, and is orthonormal: 6 columns for a body in space, 3 in the plane.
TEST(RigidModes, HoldEveryRigidMotion) {
  for_each_case([]<int D>(const Bent& body) {
    RigidModes<D> modes(body.aggregates);
    const Eigen::VectorXd free = body.ordered(body.free), x = body.ordered(body.x);
    modes.place(body.x, free, 1);
    const Eigen::MatrixXd Q = coarse_space<D>(body, modes);
    const Eigen::MatrixXd QtQ = Q.transpose() * Q;
    for (Eigen::Index i = 0; i < QtQ.rows(); ++i)
      for (Eigen::Index j = 0; j < QtQ.cols(); ++j)
        EXPECT_NEAR(QtQ(i, j), i == j && !modes.left_out(i / modes.count, i % modes.count), 1e-10);
    Eigen::VectorXd motion(x.size());
    const Vec3 turn(0.3, -0.7, 0.5), shift(1, 2, -1);
    for (Eigen::Index k = 0; k < x.size() / D; ++k) {
      Vec3 at = Vec3::Zero();
      at.head<D>() = x.segment<D>(k * D);
      const Vec3 axis = D == 3 ? turn : Vec3(0, 0, 0.4);
      motion.segment<D>(k * D) = (shift + axis.cross(at)).template head<D>().cwiseProduct(free.segment<D>(k * D));
    }
    EXPECT_LE((motion - Q * (Q.transpose() * motion)).norm(), 1e-6 * motion.norm());
    for (int a = 0; a < body.aggregates.count(); ++a) {
      EXPECT_LE(
          (Q.middleCols(a * modes.count, modes.count).transpose() * motion - modes.restricted(a, motion.data())).norm(),
          1e-12 * motion.norm());
      const Eigen::VectorXd y = random_vector(modes.count, 1, 8);
      const typename RigidModes<D>::Vector z = modes.amplitudes(a, y.data());
      for (int k = body.aggregates.start[a]; k < body.aggregates.start[a + 1]; ++k)
        EXPECT_LE((free.segment<D>(k * D).cwiseProduct(modes.at(k, z)) -
                   Q.block<D, RigidModes<D>::count>(k * D, a * modes.count) * y)
                      .norm(),
                  1e-12);
    }
  });
}

// Two nodes have no turn about their line, a single one none at all.
TEST(RigidModes, LeaveOutWhatANodeOrTwoDoNotHave) {
  const Eigen::VectorXd x = random_vector(3 * 3, 1, 2), free = Eigen::VectorXd::Ones(9);
  for (const auto& [nodes, expected] : {std::pair{1, 3}, std::pair{2, 5}, std::pair{3, 6}}) {
    Aggregates aggregates;
    for (int i = 0; i < nodes; ++i) aggregates.order.push_back(i);
    aggregates.start = {0, nodes};
    RigidModes<3> modes(aggregates);
    modes.place(x, free.head(3 * nodes), 1);
    int count = 0;
    for (int c = 0; c < 6; ++c) count += !modes.left_out(0, c);
    EXPECT_EQ(count, expected);
  }
}

TEST(CoarseMatrix, IsTheProductOfItsFactors) {
  for_each_case([]<int D>(const Bent& body) {
    constexpr int n = RigidModes<D>::count;
    const FloatMatrix<D> F = float_matrix<D>(body);
    RigidModes<D> modes(body.aggregates);
    modes.place(body.x, body.ordered(body.free), 1);
    CoarseMatrix<D> coarse(F, body.aggregates);
    ASSERT_TRUE(coarse.make(F, modes, 1));
    const Eigen::MatrixXd Q = coarse_space<D>(body, modes), A = F.scale() * dense(F);
    Eigen::MatrixXd C = Q.transpose() * A * Q;
    for (Eigen::Index i = 0; i < C.rows(); ++i)
      if (modes.left_out(i / n, i % n)) C(i, i) = 1;
    const BlockPattern& pattern = coarse.upper().pattern();
    const double size = C.cwiseAbs().maxCoeff();
    for (int a = 0; a < pattern.rows(); ++a)
      for (int b = a; b < pattern.rows(); ++b) {
        Eigen::MatrixXd block = C.block(a * n, b * n, n, n);
        for (int k = pattern.start[a]; k < pattern.start[a + 1]; ++k)
          if (pattern.column[k] == b)
            block -= Eigen::Map<const Eigen::Matrix<double, n, n, Eigen::RowMajor>>(coarse.upper().block(k));
        EXPECT_LE(block.cwiseAbs().maxCoeff(), 1e-12 * size) << a << " " << b;
      }
    const Eigen::VectorXd r = random_vector(coarse.size(), 1, 9);
    Eigen::VectorXd y(r.size());
    coarse.solve(r, y);
    EXPECT_LE((C * y - r).norm(), 1e-9 * r.norm());
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
