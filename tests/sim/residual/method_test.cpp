// What the lecture says of the methods: who is least in what, who agrees with whom, and who does not apply.
#include "sim/residual/method.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/residual/errors.h"
#include "sim/residual/grid.h"
#include "sim/residual/reference.h"
#include "sim/residual/rule.h"
#include "tests/sim/residual/problems.h"

namespace sim::residual {
namespace {

const Basis& sines = *find_basis("sines");
const Basis& polynomials = *find_basis("polynomials");
const Basis& hats = *find_basis("hats");

Errors errors_of(const Problem& problem, const Basis& basis, const Vector& c) {
  return measure(problem, Trial(basis, c), asymmetry(problem).power == 0);
}

// int g over [0,1]
template <class F>
Real integral(const Problem& problem, int n, const F& g) {
  const Grid grid = gauss_grid(problem, n);
  Real sum = 0;
  for (Eigen::Index p = 0; p < grid.x.size(); ++p) sum += grid.weight[p] * g(grid.x[p]);
  return sum;
}

TEST(Jets, HaveTheSlopeOfTheirDifferences) {
  using Call = Jet (*)(Jet);
  const Call calls[] = {[](Jet x) { return sin(x) * exp(x); },
                        [](Jet x) {
                          return tan(x) / (Jet{2, 0} + cos(x));
                        },
                        [](Jet x) { return sqrt(x) - log10(x) + log(x); },
                        [](Jet x) {
                          return pow(x, Jet{3, 0}) + pow(Jet{3, 0}, x) + pow(x, x);
                        },
                        [](Jet x) {
                          return abs(x - Jet{1, 0}) * -x;
                        }};
  const Real h = 1e-6L;
  for (const Call f : calls)
    for (const Real x : {0.3L, 0.8L}) {
      const Real difference = (f({x + h, 1}).value - f({x - h, 1}).value) / (2 * h);
      EXPECT_NEAR(f({x, 1}).slope / difference, 1, 1e-9);
    }
}

TEST(Jets, OfNegativeNumbersHaveWholePowers) {
  const Jet cube = pow(Jet{-2, 1}, Jet{3, 0});
  EXPECT_EQ(cube.value, -8);
  EXPECT_EQ(cube.slope, 12);
  EXPECT_EQ(pow(Jet{0, 1}, Jet{1, 0}).slope, 1);
  EXPECT_EQ(sqrt(Jet{0, 0}).slope, 0);
}

TEST(Rules, IntegrateTheirDegree) {
  for (const int n : {1, 2, 5, 20, 41}) {
    for (const bool gauss : {true, false}) {
      const Rule rule = gauss ? gauss_legendre(n) : fejer(n);
      const int degree = gauss ? 2 * n - 1 : n - 1;
      for (int power = 0; power <= degree; ++power) {
        const Real found = rule.weight.dot(rule.t.array().pow(Real(power)).matrix());
        EXPECT_NEAR(found, power % 2 == 0 ? Real(2) / (power + 1) : 0, 1e-15) << n << " " << power;
      }
      EXPECT_GT(rule.t[n - 1], n == 1 ? -1 : rule.t[0]);
    }
  }
}

TEST(Bases, HaveTheSlopesOfTheirDifferencesAndAreZeroAtTheEnds) {
  const Real h = 1e-5L;
  for (const Basis& basis : bases()) {
    std::vector<Sample> left(7), here(7), right(7);
    for (const Real x : {0.13L, 0.41L, 0.77L}) {
      basis.sample(x - h, left);
      basis.sample(x, here);
      basis.sample(x + h, right);
      for (int i = 0; i < 7; ++i) {
        EXPECT_NEAR(here[i].slope, (right[i].value - left[i].value) / (2 * h), 1e-6) << basis.name << i;
        if (basis.smooth) {
          EXPECT_NEAR(here[i].curvature, (right[i].slope - left[i].slope) / (2 * h), 1e-4);
        }
      }
    }
    for (const Real end : {Real(0), Real(1)}) {
      basis.sample(end, here);
      for (const Sample& u : here) EXPECT_NEAR(u.value, 0, 1e-16) << basis.name;
    }
  }
}

TEST(Bases, MonomialsAreTheSameFunction) {
  const Vector c = Vector::LinSpaced(6, 1, -2), b = to_monomials(c);
  for (const Real x : {0.2L, 0.9L}) {
    Real sum = 0;
    for (int i = 1; i <= 6; ++i) sum += b[i - 1] * std::pow(x, Real(i)) * (1 - x);
    EXPECT_NEAR(sum, Trial(polynomials, c).at(x).value, 1e-15);
  }
}

TEST(Methods, EachIsLeastInItsOwnNorm) {
  for (const Problem& problem : {test::problem_a(), test::problem_b()}) {
    const Errors squares = errors_of(problem, polynomials, least_squares(problem, polynomials, 4).c),
                 energy = errors_of(problem, polynomials, ritz(problem, polynomials, 4).c);
    for (const Method& method : methods()) {
      const Errors errors = errors_of(problem, polynomials, method.solve(problem, polynomials, 4).c);
      EXPECT_GE(*errors.residual_L2, *squares.residual_L2 * (1 - 1e-12L)) << method.name;
      EXPECT_GE(*errors.energy_norm, *energy.energy_norm * (1 - 1e-12L)) << method.name;
      EXPECT_GE(*errors.F, *energy.F - 1e-15L) << method.name;
    }
  }
}

TEST(Methods, GalerkinAndRitzAgreeToRoundOff) {
  for (const Problem& problem : {test::problem_a(), test::problem_b()})
    for (const Basis& basis : bases()) {
      const Vector a = galerkin(problem, basis, 9).c, b = ritz(problem, basis, 9).c;
      EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-15) << basis.name;
    }
}

TEST(Methods, CollocationLeavesNoResidualAtItsPoints) {
  const Problem problem = test::problem_b();
  Vector points(3);
  points << 0.11L, 0.5L, 0.62L;  // as someone might drag them
  const Trial u(polynomials, collocate(problem, polynomials, points).c);
  for (const Real x : points) EXPECT_NEAR(apply(problem, x, u.at(x)), problem.f(x).value, 1e-15);
  EXPECT_GT(std::abs(apply(problem, 0.3L, u.at(0.3L)) - problem.f(0.3L).value), 0.01);
  points[1] = points[0];
  EXPECT_NE(collocate(problem, polynomials, points).refusal, "");
}

TEST(Methods, TheResidualOfGalerkinIsOrthogonalToTheBasis) {
  const Problem problem = test::problem_c(0.1L);
  const Trial u(sines, galerkin(problem, sines, 5).c);
  for (int i = 0; i < 5; ++i) {
    const Real product = integral(problem, 5, [&](Real x) {
      std::vector<Sample> all(5);
      sines.sample(x, all);
      return all[i].value * (apply(problem, x, u.at(x)) - problem.f(x).value);
    });
    EXPECT_NEAR(product, 0, 1e-16) << i;
  }
}

// With one function, -x (1 - x): L u_n - f = -2 c - 1 for -u'' = 1.
TEST(Methods, WeightedResidualsAreTheirIntegrals) {
  Problem problem = test::problem_a();
  problem.f = test::constant(1);
  const Vector c = Vector::Constant(1, 0.3L);
  EXPECT_NEAR(weighted_residuals(problem, Trial(polynomials, c))[0], (2 * 0.3 + 1) / 6, 1e-16);
  const Problem b = test::problem_b();
  const Vector found = galerkin(b, sines, 5).c, other = least_squares(b, sines, 5).c;
  EXPECT_LT(weighted_residuals(b, Trial(sines, found)).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_GT(weighted_residuals(b, Trial(sines, other)).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(Methods, LeastSquaresAndGalerkinAreOneForEigenfunctions) {
  const Problem a = test::problem_a(), b = test::problem_b();
  EXPECT_LT((least_squares(a, sines, 6).c - galerkin(a, sines, 6).c).norm(), 1e-15);
  EXPECT_GT((least_squares(b, sines, 6).c - galerkin(b, sines, 6).c).norm(), 1e-3);
}

TEST(Methods, HatsAreExactAtTheNodesWhereTheFluxIsTheSlope) {
  const Problem problem = test::problem_a();
  const Vector c = galerkin(problem, hats, 7).c;
  for (int i = 1; i <= 7; ++i) EXPECT_NEAR(c[i - 1], problem.exact(Real(i) / 8).value, 1e-15);
}

TEST(Methods, HatsRefuseWhatNeedsASecondDerivative) {
  for (const Method& method : methods())
    EXPECT_EQ(refusal(method, hats).empty(), method.name == "galerkin" || method.name == "ritz") << method.name;
  EXPECT_NE(refusal(methods()[0], hats).find("no"), std::string::npos);
  EXPECT_EQ(refusal(methods()[0], sines), "");
}

TEST(Methods, RitzHasNoMinimumWhereTheEnergyIsNotPositive) {
  Problem problem = test::problem_a();
  problem.q = test::constant(-20);  // below -pi^2
  problem.exact = nullptr;
  EXPECT_NE(ritz(problem, sines, 3).refusal.find("no minimum"), std::string::npos);
  EXPECT_EQ(galerkin(problem, sines, 3).refusal, "");
}

TEST(Asymmetry, IsTheNumberOfTheLecture) {
  EXPECT_EQ(asymmetry(test::problem_a()).power, 0);
  EXPECT_EQ(asymmetry(test::problem_b()).power, 0);
  const Asymmetry c = asymmetry(test::problem_c(0.01L));
  EXPECT_EQ(c.power, 1);
  EXPECT_NEAR(c.difference, -1.0 / 30, 1e-16);
}

TEST(Asymmetry, IsFoundWhereTheFirstPairOfFunctionsDoesNotShowIt) {
  Problem problem = test::problem_a();
  problem.a = [](Real x) { return Jet{x - 0.5L, 1}; };
  const Asymmetry found = asymmetry(problem);
  EXPECT_EQ(found.power, 2);
  // -2 int (x - 1/2) x u^2 = -2 int x^3 (1-x)^2 (x - 1/2) = -2 (1/105 - 1/120)
  EXPECT_NEAR(found.difference, -2 * (1.0 / 105 - 1.0 / 120), 1e-16);
}

TEST(Asymmetry, RitzAnywayDoesNotSeeTheWind) {
  const Problem problem = test::problem_c(0.1L);
  Problem still = problem;
  still.a = test::constant(0);
  still.exact = nullptr;
  EXPECT_LT((ritz(problem, polynomials, 6).c - galerkin(still, polynomials, 6).c).norm(), 1e-15);
  EXPECT_NEAR(errors_of(problem, polynomials, ritz(problem, polynomials, 6).c).L2, 0.5322579518, 1e-10);
}

TEST(Peclet, NodalValuesOfTheTable) {
  for (const auto& row : test::rows_of("peclet.csv")) {
    const Problem problem = test::problem_c(row[0] == "0.1" ? 0.1L : 0.01L);
    const int n = std::stoi(row[1]);
    Vector u = Vector::Zero(n + 2);
    u.segment(1, n) = galerkin(problem, hats, n).c;
    Real worst = 0;
    int changes = 0;
    for (int i = 0; i <= n + 1; ++i) {
      worst = std::max(worst, std::abs(u[i] - problem.exact(Real(i) / (n + 1)).value));
      if (i > 0 && i <= n && (u[i] - u[i - 1]) * (u[i + 1] - u[i]) < 0) ++changes;
    }
    EXPECT_NEAR(u.minCoeff(), std::stod(row[3]), 1e-9) << row[0] << " " << n;
    EXPECT_NEAR(u.maxCoeff() / std::stod(row[4]), 1, 1e-9) << row[0] << " " << n;
    EXPECT_NEAR(worst / std::stod(row[5]), 1, 1e-9) << row[0] << " " << n;
    EXPECT_EQ(changes, std::stoi(row[6])) << row[0] << " " << n;
  }
}

}  // namespace
}  // namespace sim::residual
