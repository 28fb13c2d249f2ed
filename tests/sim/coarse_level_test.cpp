// The coarse level of sim/linear/: groups of nodes, rigid modes against rigid motions, the coarse matrix against the
// dense product.
#include <Eigen/Geometry>

#include "tests/sim/linear_support.h"

namespace sim {
namespace {

using test::Bent, test::coarse_space, test::dense, test::for_each_case, test::random_vector;

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

}  // namespace
}  // namespace sim
