// The formulas of contact, each against differences of the one before it.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <functional>
#include <random>

#include "sim/contact/barrier.h"
#include "sim/contact/mollifier.h"
#include "sim/contact/pair_tangent.h"
#include "sim/contact/smooth_friction.h"
#include "sim/contact/step_limit.h"

namespace sim {
namespace {

struct Positions {
  Vec3 x[4];
};

Positions random_positions(std::mt19937& random, double flat = 1) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Positions p;
  for (Vec3& x : p.x) x = {uniform(random), uniform(random), flat * uniform(random)};
  return p;
}

Positions moved(Positions p, int k, double by) {
  p.x[k / 3][k % 3] += by;
  return p;
}

// The feature of a random pair, with its own positions.
struct Case {
  Feature feature;
  Positions at;
};

std::vector<Case> random_cases(int count, double flat = 1) {
  std::mt19937 random(5);
  std::vector<Case> cases;
  for (int k = 0; k < count; ++k)
    for (const PairKind kind : {PairKind::point_edge, PairKind::point_triangle, PairKind::edge_edge}) {
      const Positions p = random_positions(random, flat);
      const Nearest n = nearest(kind, p.x);
      Case c{n.feature, p};
      for (int i = 0; i < node_count(n.feature); ++i) c.at.x[i] = p.x[n.node[i]];
      cases.push_back(c);
    }
  return cases;
}

// The distance by trying points of both primitives: knows nothing of features.
double sampled_distance(PairKind kind, const Vec3* x, int n) {
  double best = INFINITY;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double s = i / double(n), t = j / double(n);
      Vec3 w;
      if (kind == PairKind::point_edge)
        w = x[0] - (1 - s) * x[1] - s * x[2];
      else if (kind == PairKind::edge_edge)
        w = (1 - s) * x[0] + s * x[1] - (1 - t) * x[2] - t * x[3];
      else
        w = x[0] - (1 - s) * x[1] - s * ((1 - t) * x[2] + t * x[3]);
      best = std::min(best, w.norm());
    }
  return best;
}

TEST(Distance, IsTheLeastOverBothPrimitives) {
  std::mt19937 random(3);
  for (int k = 0; k < 200; ++k)
    for (const PairKind kind : {PairKind::point_edge, PairKind::point_triangle, PairKind::edge_edge}) {
      const Positions p = random_positions(random);
      const double d = nearest(kind, p.x).d, sampled = sampled_distance(kind, p.x, 60);
      EXPECT_LE(d, sampled + 1e-14);
      EXPECT_GE(d, sampled - 0.06);
    }
}

TEST(Distance, OfDegenerateAndParallelPrimitives) {
  const Vec3 parallel[] = {{0, 0, 0}, {1, 0, 0}, {0.25, 0.5, 0}, {0.75, 0.5, 0}};
  EXPECT_DOUBLE_EQ(nearest_edge_edge(parallel).d, 0.5);
  const Vec3 apart[] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  EXPECT_DOUBLE_EQ(nearest_edge_edge(apart).d, 1);
  const Vec3 needle[] = {{0.3, 2, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  EXPECT_DOUBLE_EQ(nearest_point_triangle(needle).d, 2);
  const Vec3 point[] = {{0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  EXPECT_DOUBLE_EQ(nearest_point_triangle(point).d, std::sqrt(2.0));
}

TEST(Distance, GradientAndHessianAreThoseOfDifferences) {
  for (const double flat : {1.0, 0.0})
    for (const Case& c : random_cases(60, flat)) {
      const Distance at(c.feature, c.at.x);
      if (at.d < 0.05) continue;
      const PairVector g = at.gradient();
      const PairMatrix H = at.hessian();
      const double h = 1e-6;
      for (int k = 0; k < 3 * at.nodes; ++k) {
        if (flat == 0 && k % 3 == 2) continue;
        const Distance above(c.feature, moved(c.at, k, h).x), below(c.feature, moved(c.at, k, -h).x);
        const double size = 1 + H.cwiseAbs().maxCoeff();
        EXPECT_NEAR((above.d - below.d) / (2 * h), g[k], 1e-8 * size);
        EXPECT_NEAR(((above.gradient() - below.gradient()) / (2 * h) - H.col(k)).cwiseAbs().maxCoeff(), 0,
                    1e-6 * size * size);
      }
    }
}

TEST(Distance, ForcesOfAPairHaveNoSumAndNoMoment) {
  for (const Case& c : random_cases(60)) {
    const Distance at(c.feature, c.at.x);
    const PairVector g = at.gradient();
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    for (int i = 0; i < at.nodes; ++i) {
      force += g.segment<3>(3 * i);
      moment += c.at.x[i].cross(g.segment<3>(3 * i));
    }
    EXPECT_LT(force.norm(), 1e-13);
    EXPECT_LT(moment.norm(), 1e-12);
  }
}

TEST(Barrier, DerivativesAreThoseOfDifferences) {
  const double dh = 0.3, h = 1e-6;
  for (const double gap : {0.001, 0.05, 0.15, 0.29, 0.2999, 0.3, 0.31}) {
    const Barrier at(gap, dh), above(gap + gap * h, dh), below(gap - gap * h, dh);
    EXPECT_NEAR((above.b - below.b) / (2 * gap * h), at.first, 1e-6 * (1 + std::abs(at.first)));
    EXPECT_NEAR((above.first - below.first) / (2 * gap * h), at.second, 1e-5 * (1 + std::abs(at.second)));
  }
}

// Gap at rest under a pressure p: the table of the method's description. [-b' = p/kappa]
TEST(Barrier, GapUnderPressure) {
  const double table[][2] = {{0.01, 0.943}, {0.1, 0.829}, {1, 0.532}, {10, 0.122}, {100, 0.0108}, {1000, 0.00101}};
  for (const auto& [pressure, s] : table) {
    double low = 1e-9, high = 1;
    for (int k = 0; k < 100; ++k) (-Barrier((low + high) / 2, 1).first > pressure ? low : high) = (low + high) / 2;
    EXPECT_NEAR(low, s, 0.005 * s + 5e-4) << pressure;
  }
}

TEST(Mollifier, DerivativesAreThoseOfDifferences) {
  std::mt19937 random(9);
  for (int k = 0; k < 60; ++k) {
    Positions p = random_positions(random);
    p.x[3] = p.x[2] + 0.9 * (p.x[1] - p.x[0]) + 0.02 * (p.x[3] - p.x[2]);  // nearly parallel
    const double e = mollifier_start(1.5, 1.5), h = 1e-6;
    const MollifierTangent at(p.x, e);
    EXPECT_NEAR(at.M, mollifier(p.x, e), 1e-14);
    for (int c = 0; c < 12; ++c) {
      const MollifierTangent above(moved(p, c, h).x, e), below(moved(p, c, -h).x, e);
      EXPECT_NEAR((above.M - below.M) / (2 * h), at.gradient[c], 1e-6 * (1 + at.gradient.norm()));
      EXPECT_NEAR(((above.gradient - below.gradient) / (2 * h) - at.hessian.col(c)).norm(), 0,
                  1e-6 * (1 + at.hessian.norm()));
    }
  }
}

TEST(PairTangent, ClampIsThatOfTheWholeMatrix) {
  for (const Case& c : random_cases(60)) {
    const Distance at(c.feature, c.at.x);
    const Barrier b(at.d, 2 * at.d);
    const PairMatrix exact = pair_tangent(at, b.first, b.second, Definiteness::none);
    const PairMatrix clamped = pair_tangent(at, b.first, b.second, Definiteness::clamp);
    EXPECT_LT((without_negative_part(exact) - clamped).norm(), 1e-9 * (1 + exact.norm()));
  }
}

// However near: that the normal turns as the points slide is a small part of the matrix, but all that it has along the
// surface. Without it bodies that slide at a thousandth of the barrier's width took thousands of iterations.
TEST(PairTangent, KnowsHowTheNormalTurnsAtAnyDistance) {
  const double d = 1e-6;
  const Vec3 face[] = {{0.3, d, 0.3}, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  const Distance at(Feature::point_triangle, face);
  const Barrier b(at.d, 2 * at.d);
  PairVector along = PairVector::Zero();
  along.segment<3>(0) = Vec3(1, 0, 0);  // the point slides
  along.segment<3>(6) = Vec3(0, 1, 0);  // and the face turns against its way
  along.segment<3>(0) += Vec3(0, at.gradient().segment<3>(6).dot(Vec3(0, -1, 0)), 0);  // at the same distance
  EXPECT_NEAR(at.gradient().dot(along), 0, 1e-12);
  const double exact = along.dot(pair_tangent(at, b.first, b.second, Definiteness::none) * along);
  EXPECT_NEAR(exact, -2 * b.first, 0.01 * std::abs(b.first));
  EXPECT_GE(along.dot(pair_tangent(at, b.first, b.second, Definiteness::clamp) * along), exact);
}

TEST(SmoothFriction, DerivativesAreThoseOfDifferences) {
  const double eps = 0.2, h = 1e-7;
  const Vec3 n = Vec3(1, 2, -0.5).normalized();
  for (const double size : {0.01, 0.1, 0.19, 0.5}) {
    const Vec3 v = slip_of(Vec3(0.3, -1, 0.7), n).normalized() * size;
    const Eigen::Matrix3d K = slip_tangent(v, n, eps);
    for (int k = 0; k < 3; ++k) {
      const Vec3 by = slip_of(Vec3::Unit(k), n) * h;
      EXPECT_NEAR((SmoothFriction((v + by).norm(), eps).f0 - SmoothFriction((v - by).norm(), eps).f0) / (2 * h),
                  slip_gradient(v, eps).dot(by) / h, 1e-7);
      EXPECT_LT(((slip_gradient(v + by, eps) - slip_gradient(v - by, eps)) / (2 * h) - K.col(k)).norm(), 1e-6);
    }
  }
}

// The limit is safe: on the whole way up to it the pair is apart by a share of the start's distance.
TEST(StepLimit, LeavesAGapOnTheWholeWay) {
  std::mt19937 random(17);
  int limited = 0;
  for (int k = 0; k < 1500; ++k)
    for (const PairKind kind : {PairKind::point_edge, PairKind::point_triangle, PairKind::edge_edge}) {
      const Positions p = random_positions(random, k % 2 ? 1 : 0.02);
      Positions way = random_positions(random);
      const double start = nearest(kind, p.x).d, a = step_limit(kind, p.x, way.x, 0, 1);
      limited += a < 1;
      ASSERT_GT(a, 0);
      for (int i = 0; i <= 50; ++i) {
        Positions at = p;
        for (int n = 0; n < 4; ++n) at.x[n] += a * i / 50 * way.x[n];
        ASSERT_GT(nearest(kind, at.x).d, 0.01 * start);
      }
    }
  EXPECT_GT(limited, 200);
}

// What slides past is let through, however near it is; what turns into the other's way is not.
TEST(StepLimit, LetsThroughWhatSlides) {
  const Vec3 cross[] = {{-0.5, 1e-6, 0}, {0.5, 1e-6, 0}, {0, 0, -0.5}, {0, 0, 0.5}};
  const Vec3 aside[] = {{0.4, 0, 0.2}, {0.4, 0, 0.2}, {-0.3, 0, 0}, {-0.3, 0, 0}};
  EXPECT_EQ(step_limit(PairKind::edge_edge, cross, aside, 0, 1), 1);
  const Vec3 turning[] = {{0.4, -0.1, 0.2}, {0.4, 0.1, 0.2}, {-0.3, 0, 0}, {-0.3, 0, 0}};
  const double a = step_limit(PairKind::edge_edge, cross, turning, 0, 1);
  EXPECT_GT(a, 3e-4);
  EXPECT_LT(a, 0.1);
}

TEST(StepLimit, StopsBeforeWhatItWouldPass) {
  const Vec3 face[] = {{0.2, 1, 0.2}, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  const Vec3 down[] = {{0, -4, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  const double a = step_limit(PairKind::point_triangle, face, down, 0, 1);
  EXPECT_LT(a, 0.25);
  EXPECT_GT(a, 0.2);
  EXPECT_LT(step_limit(PairKind::point_triangle, face, down, 0.5, 1), 0.125);
  // All together: no limit, however far.
  const Vec3 all[] = {{0, -4, 0}, {0, -4, 0}, {0, -4, 0}, {0, -4, 0}};
  EXPECT_EQ(step_limit(PairKind::point_triangle, face, all, 0, 1), 1);
}

}  // namespace
}  // namespace sim
