// For every element with every material: forces, products and matrices against each other and against differences.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "sim/build/parts.h"
#include "sim/solve/tangent_operator.h"
#include "tests/sim/scenes.h"

namespace sim {
namespace {

using test::kinds;
using test::models;

struct Pair {
  test::Kind kind;
  const char* model;
};

std::vector<Pair> pairs() {
  std::vector<Pair> all;
  for (const test::Kind& kind : kinds)
    for (const char* model : models) all.push_back({kind, model});
  return all;
}

class Structure : public ::testing::TestWithParam<Pair> {
 protected:
  Structure() : system_(test::free_body(GetParam().kind, GetParam().model)), tangent_(parts_of(system_).model, 1) {
    const Eigen::Index n = parts_of(system_).model.dofs();
    x_ = parts_of(system_).model.X + test::random_vector(n, 0.05, 3);
    p_ = test::random_vector(n, 1, 4);
    f_.resize(n);
    tangent_.begin_step(at(x_));
  }

  Motion at(const Eigen::VectorXd& x) { return {x, still_, 0, 0}; }
  double energy(const Eigen::VectorXd& x) { return tangent_.energy(at(x)); }
  Eigen::VectorXd forces(const Eigen::VectorXd& x) {
    Eigen::VectorXd f(x.size());
    tangent_.forces(at(x), f);
    return f;
  }
  Eigen::VectorXd product(Definiteness fix, const Eigen::VectorXd& p) {
    tangent_.linearise(at(x_), 0, fix, f_);
    Eigen::VectorXd y(p.size());
    tangent_.multiply(p, y);
    return y;
  }
  Eigen::MatrixXd matrix(Definiteness fix) {
    tangent_.linearise(at(x_), 0, fix, f_);
    BlockMatrix A(*parts_of(system_).model.pattern, system_.dimension());
    tangent_.assemble(A);
    Eigen::MatrixXd dense(x_.size(), x_.size());
    for (Eigen::Index k = 0; k < x_.size(); ++k) {
      Eigen::VectorXd column(x_.size());
      A.multiply(Eigen::VectorXd::Unit(x_.size(), k), column, 1);
      dense.col(k) = column;
    }
    return dense;
  }

  System system_;
  TangentOperator tangent_;
  Eigen::VectorXd still_ = Eigen::VectorXd::Zero(parts_of(system_).model.dofs());
  Eigen::VectorXd x_, p_, f_;
};

TEST_P(Structure, ForceIsMinusTheGradientOfTheEnergy) {
  const double e = 1e-6, scale = forces(x_).norm() * p_.norm();
  const double difference = (energy(x_ + e * p_) - energy(x_ - e * p_)) / (2 * e);
  EXPECT_NEAR(-forces(x_).dot(p_), difference, 1e-7 * scale);
}

TEST_P(Structure, ProductIsTheDerivativeOfTheForce) {
  const double e = 1e-6;
  const Eigen::VectorXd difference = (forces(x_ - e * p_) - forces(x_ + e * p_)) / (2 * e);
  EXPECT_LT((product(Definiteness::none, p_) - difference).norm(), 1e-6 * difference.norm());
}

TEST_P(Structure, LinearisingGivesTheForcesToo) {
  tangent_.linearise(at(x_), 0, Definiteness::clamp, f_);
  EXPECT_LT((f_ - forces(x_)).norm(), 1e-10 * f_.norm());
}

TEST_P(Structure, MatrixIsSymmetricAndIsTheProduct) {
  for (const Definiteness fix : {Definiteness::none, Definiteness::clamp, Definiteness::abs}) {
    const Eigen::MatrixXd A = matrix(fix);
    EXPECT_LT((A - A.transpose()).norm(), 1e-12 * A.norm());
    EXPECT_LT((A * p_ - product(fix, p_)).norm(), 1e-11 * A.norm() * p_.norm());
    Eigen::VectorXd diagonal(p_.size());
    tangent_.diagonal(diagonal);
    EXPECT_LT((A.diagonal() - diagonal).norm(), 1e-12 * A.norm());
  }
}

TEST_P(Structure, ClampAndAbsArePositiveSemidefinite) {
  for (const Definiteness fix : {Definiteness::clamp, Definiteness::abs}) {
    const Eigen::MatrixXd A = matrix(fix);
    const Eigen::VectorXd e = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues();
    EXPECT_GE(e.minCoeff(), -1e-9 * e.maxCoeff());
  }
}

TEST_P(Structure, ForcesAndTorquesSumToZero) {
  const Eigen::VectorXd f = forces(x_);
  const int D = system_.dimension();
  Vec3 sum = Vec3::Zero(), torque = Vec3::Zero();
  for (Eigen::Index i = 0; i < f.size(); i += D) {
    Vec3 x = Vec3::Zero(), fi = Vec3::Zero();
    x.head(D) = x_.segment(i, D);
    fi.head(D) = f.segment(i, D);
    sum += fi;
    torque += x.cross(fi);
  }
  EXPECT_LT(sum.norm(), 1e-12 * f.norm());
  // A linear material does not know rotations, so it keeps no angular momentum away from rest.
  if (std::string(GetParam().model) != "linear") {
    EXPECT_LT(torque.norm(), 1e-11 * f.norm());
  }
}

// A homogeneous deformation leaves the interior in balance, on irregular meshes too.
TEST_P(Structure, PatchTest) {
  const int D = system_.dimension();
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(D, D);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) A(i, j) += 0.05 * (i + 1) - 0.03 * j;
  const Eigen::VectorXd& X = parts_of(system_).model.X;
  Eigen::VectorXd x(X.size());
  for (Eigen::Index i = 0; i < X.size(); i += D) x.segment(i, D) = A * X.segment(i, D);
  const Eigen::VectorXd f = forces(x);
  const Mesh& mesh = *system_.bodies()[0].mesh;
  const int M = info(mesh.kind).dimension;
  const Eigen::VectorXd low = mesh.X.rowwise().minCoeff(), high = mesh.X.rowwise().maxCoeff();
  int inside = 0;
  for (int i = 0; i < mesh.node_count(); ++i) {
    bool interior = true;
    for (int c = 0; c < M; ++c) interior = interior && mesh.X(c, i) > low[c] + 1e-9 && mesh.X(c, i) < high[c] - 1e-9;
    if (!interior) continue;
    ++inside;
    EXPECT_LT(f.segment(static_cast<Eigen::Index>(i) * D, D).norm(), 1e-12 * f.norm());
  }
  EXPECT_GT(inside, 0);
}

INSTANTIATE_TEST_SUITE_P(EveryElementAndMaterial, Structure, ::testing::ValuesIn(pairs()), [](const auto& info) {
  std::string name =
      std::string(info.param.kind.element) + (info.param.kind.membrane ? "_membrane_" : "_") + info.param.model;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace sim
