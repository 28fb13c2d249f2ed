// Every material in every dimension: derivatives against differences, small-strain moduli, rotation invariance.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "sim/material/list.h"

namespace sim {
namespace {

constexpr double young = 1e6, poisson = 0.3;

template <class Material_, int D_, int M_>
struct Case {
  using Material = Material_;
  static constexpr int D = D_, M = M_;
  using Matrix = Mat<double, D, M>;
  static constexpr bool frame = requires { Material::in_rest_frame; };

  static Lame constants() { return lame(young, poisson, D > M); }
  static Material material() { return Material(constants(), M); }

  // Near rest, stretched by up to a third; J > 0.
  static Matrix deformation(std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(-0.25, 0.25);
    Matrix F = Matrix::identity();
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < M; ++j) F(i, j) += uniform(random);
    return F;
  }
  static Matrix direction(std::mt19937& random) {
    std::normal_distribution<double> normal;
    Matrix p;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < M; ++j) p(i, j) = normal(random);
    return p;
  }
};

template <class List>
struct Cases;
template <class... Material>
struct Cases<TypeList<Material...>> {
  using Types = ::testing::Types<Case<Material, 2, 2>..., Case<Material, 3, 2>..., Case<Material, 3, 3>...>;
};

template <class T>
class MaterialTest : public ::testing::Test {};
TYPED_TEST_SUITE(MaterialTest, Cases<Materials>::Types);

TYPED_TEST(MaterialTest, StressIsTheDerivativeOfTheEnergy) {
  std::mt19937 random(1);
  const auto material = TypeParam::material();
  for (int n = 0; n < 50; ++n) {
    const auto F = TypeParam::deformation(random), p = TypeParam::direction(random);
    const double e = 1e-5;
    const double difference = (material.psi(F + e * p) - material.psi(F - e * p)) / (2 * e);
    EXPECT_NEAR(contract(material.P(F), p), difference, 1e-7 * young);
  }
}

TYPED_TEST(MaterialTest, TangentIsTheDerivativeOfTheStress) {
  std::mt19937 random(2);
  const auto material = TypeParam::material();
  for (int n = 0; n < 50; ++n) {
    const auto F = TypeParam::deformation(random), p = TypeParam::direction(random);
    typename TypeParam::Matrix P;
    Tangent<double, TypeParam::D, TypeParam::M> t;
    material.linearise(F, P, t);
    const auto dP = apply(t, p);
    const double e = 1e-6;
    const auto difference = (1 / (2 * e)) * (material.P(F + e * p) - material.P(F - e * p));
    const auto closed = material.P(F);
    for (int i = 0; i < TypeParam::D; ++i)
      for (int j = 0; j < TypeParam::M; ++j) {
        EXPECT_NEAR(dP(i, j), difference(i, j), 1e-6 * young);
        EXPECT_NEAR(P(i, j), closed(i, j), 1e-9 * young) << "stretches and closed form differ";
      }
  }
}

TYPED_TEST(MaterialTest, RestIsFreeOfStressAndEnergy) {
  const auto material = TypeParam::material();
  const auto I = TypeParam::Matrix::identity();
  EXPECT_NEAR(material.psi(I), 0, 1e-9 * young);
  const auto P = material.P(I);
  EXPECT_NEAR(contract(P, P), 0, 1e-18 * young * young);
}

// d2Psi at rest: lambda + 2 mu along an axis, 4 mu for the pair +e, -e. [mathematics.md 3]
TYPED_TEST(MaterialTest, SmallStrainIsLinearElasticity) {
  const auto material = TypeParam::material();
  const Lame l = TypeParam::constants();
  const double e = 1e-3;
  auto I = TypeParam::Matrix::identity(), axial = TypeParam::Matrix::zero(), pair = axial;
  axial(0, 0) = 1;
  pair(0, 0) = 1;
  pair(1, 1) = -1;
  const auto second = [&](const typename TypeParam::Matrix& p) {
    return (material.psi(I + e * p) - 2 * material.psi(I) + material.psi(I - e * p)) / (e * e);
  };
  EXPECT_NEAR(second(axial) / (l.lambda + 2 * l.mu), 1, 1e-4);
  EXPECT_NEAR(second(pair) / (4 * l.mu), 1, 1e-4);
}

TYPED_TEST(MaterialTest, RotationChangesNothingUnlessLinear) {
  std::mt19937 random(3);
  const auto material = TypeParam::material();
  const auto F = TypeParam::deformation(random);
  const double c = std::cos(0.7), s = std::sin(0.7);
  auto R = Mat<double, TypeParam::D, TypeParam::D>::identity();
  R(0, 0) = R(1, 1) = c;
  R(0, 1) = -s;
  R(1, 0) = s;
  const double turned = material.psi(R * F), plain = material.psi(F);
  if (TypeParam::frame) {
    EXPECT_GT(std::abs(turned - plain), 1e-3 * young);
  } else {
    EXPECT_NEAR(turned, plain, 1e-9 * young);
  }
}

// The whole D M x D M matrix, for its eigenvalues.
template <class C>
Eigen::MatrixXd dense(const Tangent<double, C::D, C::M>& t) {
  Eigen::MatrixXd A(C::D * C::M, C::D * C::M);
  for (int k = 0; k < A.cols(); ++k) {
    auto p = C::Matrix::zero();
    p(k / C::M, k % C::M) = 1;
    const auto column = apply(t, p);
    for (int i = 0; i < A.rows(); ++i) A(i, k) = column(i / C::M, i % C::M);
  }
  return A;
}

// The same matrix with f of its eigenvalues. (No template: Eigen's products take long to compile.)
Eigen::MatrixXd rebuilt(const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>& of, double (*f)(double)) {
  Eigen::VectorXd values = of.eigenvalues();
  for (double& e : values) e = f(e);
  return of.eigenvectors() * values.asDiagonal() * of.eigenvectors().transpose();
}

double distance(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).norm();
}

TYPED_TEST(MaterialTest, ClampAndAbsActOnTheEigenvaluesOfTheTangent) {
  std::mt19937 random(4);
  const auto material = TypeParam::material();
  int negative = 0;
  for (int n = 0; n < 60; ++n) {
    auto F = TypeParam::deformation(random);
    for (int i = 0; i < TypeParam::D; ++i) F(i, 0) *= 0.4;  // squashed: there the tangents lose definiteness
    typename TypeParam::Matrix P;
    Tangent<double, TypeParam::D, TypeParam::M> t;
    material.linearise(F, P, t);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> exact(dense<TypeParam>(t));
    negative += exact.eigenvalues().minCoeff() < 0;
    auto clamped = t, absolute = t;
    make_definite(clamped, Definiteness::clamp);
    make_definite(absolute, Definiteness::abs);
    const double scale = exact.eigenvalues().cwiseAbs().maxCoeff();
    const Eigen::MatrixXd positive = rebuilt(exact, [](double e) { return std::max(e, 0.0); });
    const Eigen::MatrixXd magnitude = rebuilt(exact, [](double e) { return std::abs(e); });
    EXPECT_LT(distance(dense<TypeParam>(clamped), positive), 1e-9 * scale);
    EXPECT_LT(distance(dense<TypeParam>(absolute), magnitude), 1e-9 * scale);
  }
  if (!TypeParam::frame) {
    EXPECT_GT(negative, 0) << "nothing was mended: the test does not test";
  }
}

TYPED_TEST(MaterialTest, StiffnessBlockIsTheTangentBetweenTwoGradients) {
  std::mt19937 random(5);
  constexpr int D = TypeParam::D, M = TypeParam::M;
  const auto F = TypeParam::deformation(random);
  typename TypeParam::Matrix P;
  Tangent<double, D, M> t;
  TypeParam::material().linearise(F, P, t);
  const double g[2][3] = {{0.3, -1.2, 0.7}, {1.1, 0.4, -0.5}};
  double r[2][M];
  for (int a = 0; a < 2; ++a)
    for (int m = 0; m < M; ++m) {
      r[a][m] = 0;
      for (int k = 0; k < M; ++k) r[a][m] += t.V(k, m) * g[a][k];
    }
  const Mat<double, D, D> K = stiffness_block<double, D, M>(t, r[0], r[1]);
  for (int j = 0; j < D; ++j) {
    auto dF = TypeParam::Matrix::zero();
    for (int m = 0; m < M; ++m) dF(j, m) = g[1][m];
    const auto dP = apply(t, dF);
    for (int i = 0; i < D; ++i) {
      double force = 0;
      for (int m = 0; m < M; ++m) force += dP(i, m) * g[0][m];
      EXPECT_NEAR(K(i, j), force, 1e-9 * young);
    }
  }
}

}  // namespace
}  // namespace sim
