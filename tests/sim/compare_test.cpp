// Errors between runs: exact on fields that are known, and a reference that cannot be trusted is found.
#include <algorithm>
#include <cmath>

#include "sim/build/build.h"
#include "sim/mesh/input_error.h"
#include "sim/mesh/quadratic.h"
#include "sim/mesh/refine.h"
#include "sim/study/front.h"
#include "sim/study/reference_check.h"
#include "sim/study/slope.h"
#include "sim/time/implicit.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

Scene of_mesh(const Mesh& mesh) {
  Scene scene;
  scene.dimension = mesh.dimension();
  Body body;
  body.name = "body";
  body.mesh = mesh;
  body.materials = {MaterialSpec{}};
  scene.bodies = {body};
  return scene;
}

// x = X + f(X) at every node.
template <class F>
State displaced(const System& system, const F& f) {
  State state = system.initial_state();
  const int D = system.dimension();
  for (Eigen::Index i = 0; i < state.x.size(); i += D) {
    Vec3 X = Vec3::Zero();
    X.head(D) = state.x.segment(i, D);
    const Vec3 u = f(X);
    state.x.segment(i, D) += u.head(D);
  }
  return state;
}

// One frame of a field on a mesh, seen at the nodes of another.
template <class F>
Trajectory seen(const Mesh& mesh, const SamplePoints& points, const F& f) {
  const System system(of_mesh(mesh));
  Trajectory path;
  add_frame(system, displaced(system, f), Sampler(system, points), path);
  return path;
}

Vec3 linear_field(const Vec3& X) {
  return {0.1 * X.x() - 0.2 * X.y(), 0.3 * X.y() + 0.05 * X.z() + 0.01, -0.1 * X.x() + 0.2 * X.z()};
}
Vec3 quadratic_field(const Vec3& X) {
  return {0.1 * X.x() * X.y(), 0.2 * X.y() * X.y() - 0.1 * X.z(), 0.05 * X.x() * X.z()};
}

Mesh box(ElementKind kind, int n, double grading = 1.4) {
  return generate_box({2, 1, 1}, {2 * n, n, n}, {grading, 1, 1}, kind);
}

TEST(Compare, LinearFieldsAreTheSameOnEveryMesh) {
  const SamplePoints points = sample_points(System(of_mesh(box(ElementKind::tet4, 2))));
  const Trajectory own = seen(box(ElementKind::tet4, 2), points, linear_field);
  for (const Mesh& other : {box(ElementKind::tet4, 1), box(ElementKind::tet4, 3), box(ElementKind::tet10, 1),
                            box(ElementKind::hex8, 3, 1.0), refine(box(ElementKind::tet4, 2))}) {
    const Difference apart = difference(own, seen(other, points, linear_field), points);
    EXPECT_LT(apart.max, 1e-14);
  }
  const auto wrong = [](const Vec3& X) { return Vec3(linear_field(X) + Vec3(0, 0.02, 0)); };
  EXPECT_NEAR(difference(own, seen(box(ElementKind::tet4, 3), points, wrong), points).rms, 0.01, 1e-14);
}

TEST(Compare, QuadraticFieldsAreTheSameOnQuadraticMeshes) {
  const SamplePoints points = sample_points(System(of_mesh(box(ElementKind::tet10, 2))));
  const Trajectory own = seen(box(ElementKind::tet10, 2), points, quadratic_field);
  for (const Mesh& other : {box(ElementKind::tet10, 1), box(ElementKind::tet10, 3), refine(box(ElementKind::tet10, 2))})
    EXPECT_LT(difference(own, seen(other, points, quadratic_field), points).max, 1e-13);
  EXPECT_GT(difference(own, seen(box(ElementKind::tet4, 2), points, quadratic_field), points).max, 1e-4);
}

TEST(Compare, PointsOutsideTheOtherMeshAreRefused) {
  const SamplePoints points = sample_points(System(of_mesh(box(ElementKind::tet4, 2))));
  const System smaller(of_mesh(generate_box({1, 1, 1}, {2, 2, 2}, {1, 1, 1}, ElementKind::tet4)));
  EXPECT_THROW(Sampler(smaller, points), InputError);
}

TEST(Compare, WeightsAreTheMassWhateverTheMassMatrix) {
  for (const char* element : {"tet4", "tet10", "hex8"}) {
    Scene scene = test::free_body({element, false}, "linear");
    const SamplePoints lumped = sample_points(System(scene));
    scene.bodies[0].mass = MassMatrix::consistent;
    const SamplePoints consistent = sample_points(System(scene));
    EXPECT_NEAR(lumped.mass.sum(), 1.2 * 1 * 0.9 * 1000, 1e-9) << element;
    EXPECT_NEAR(consistent.mass.sum(), lumped.mass.sum(), 1e-9) << element;
    EXPECT_GT(consistent.mass.minCoeff(), 0) << element;
  }
}

TEST(Compare, DriftAndCentreAreWhatWasPutIn) {
  const Mesh mesh = box(ElementKind::tet4, 2);
  const SamplePoints points = sample_points(System(of_mesh(mesh)));
  Trajectory a = seen(mesh, points, linear_field), b = a;
  a.measures[0].kinetic = 3;
  a.measures[0].elastic = 5;
  b.measures[0] = a.measures[0];
  b.measures[0].potential += 2;
  b.measures[0].p += Vec3(0, std::sqrt(2 * points.mass.sum() * 3), 0);
  for (Eigen::Index i = 0; i < b.x[0].size(); i += 3) b.x[0][i] += 0.5;
  const Drift drift = sim::drift(b, a, points);
  EXPECT_NEAR(drift.energy, 2.0 / 8, 1e-12);
  EXPECT_NEAR(drift.mean_energy, 2.0 / 8, 1e-12);
  EXPECT_NEAR(drift.momentum, 1, 1e-12);
  EXPECT_NEAR(centre_difference(b, a, points), 0.25, 1e-12);
}

TEST(Compare, WhatIsNotFiniteIsInfinitelyFar) {
  const Mesh mesh = box(ElementKind::tet4, 1);
  const SamplePoints points = sample_points(System(of_mesh(mesh)));
  const Trajectory a = seen(mesh, points, linear_field);
  Trajectory b = a;
  b.x[0][4] = std::nan("");
  EXPECT_TRUE(std::isinf(difference(a, b, points).rms));
}

TEST(Slope, OfAPowerIsItsExponent) {
  const double h[] = {0.1, 0.05, 0.025}, e[] = {3e-2, 0.75e-2, 0.1875e-2};
  EXPECT_NEAR(log_slope(h, e), 2, 1e-12);
}

TEST(Front, KeepsWhatNothingBeats) {
  const WorkError points[] = {{1, 1}, {2, 0.5}, {3, 0.6}, {4, 0.1}, {4, 0.1}, {1, 2}, {8, 0.09}};
  const std::vector<int> members = front(points);
  EXPECT_EQ(members, (std::vector<int>{0, 1, 3, 6}));
  EXPECT_EQ(knee(points, members), 3);
}

// Half a second of the plate under any row of coefficients.
Trajectory stepped(const Scheme& scheme, int substeps) {
  Scene scene = test::plate("backward-euler", substeps);
  scene.solver.tolerance = 1e-10;
  const System system(scene);
  const Sampler sampler(system, sample_points(system));
  const auto parts = build(scene, 1);
  ImplicitStepper stepper(parts->model, scheme, 1);
  State state = system.initial_state();
  Trajectory path;
  for (int k = 1; k <= 15 * substeps; ++k) {
    EXPECT_EQ(stepper.step(state).failure, "");
    if (k % substeps == 0) add_frame(system, state, sampler, path);
  }
  return path;
}

ReferenceCheck check_with(const Scheme& other) {
  const Scheme& scheme = *find_scheme("tr-bdf2");
  const SamplePoints points = sample_points(System(test::plate("backward-euler", 1)));
  return check_reference({stepped(scheme, 32), stepped(scheme, 16), stepped(other, 16), stepped(other, 8)}, points);
}

TEST(ReferenceCheck, TwoGoodSchemesAgree) {
  for (const char* name : {"sdirk2", "bdf2", "trapezoidal"}) {
    const ReferenceCheck check = check_with(*find_scheme(name));
    EXPECT_TRUE(check.agrees) << name;
    EXPECT_FALSE(check.diverges) << name;
    EXPECT_EQ(check.frames, 15) << name;
    EXPECT_GE(check.uncertainty, check.moved) << name;
    EXPECT_LT(check.uncertainty, 1e-3) << name;
    EXPECT_GT(check.other_order, 1.7) << name;
  }
}

// Each number of the second scheme in turn is made wrong. Most go to another limit; a wrong g of the first stage costs
// the order.
TEST(ReferenceCheck, AWrongCoefficientIsFound) {
  const Scheme& good = *find_scheme("sdirk2");
  int tried = 0;
  for (std::size_t stage = 0; stage < good.stages.size(); ++stage)
    for (int number = 0; number < 2 * source_count + 1; ++number) {
      std::vector<Stage> stages(good.stages.begin(), good.stages.end());
      double& coefficient = number == 2 * source_count ? stages[stage].g
                            : number < source_count    ? stages[stage].c[number]
                                                       : stages[stage].d[number - source_count];
      if (coefficient == 0) continue;
      // x* itself is taken from step to step: a little is enough there, and more would blow up.
      coefficient *= number < source_count ? 1.0003 : 1.03;
      Scheme other = good;
      other.stages = stages;
      const ReferenceCheck check = check_with(other);
      EXPECT_TRUE(!check.agrees || check.other_order < 1.3)
          << "stage " << stage << ", number " << number << ": apart " << check.apart << ", moved " << check.moved
          << ", order " << check.other_order;
      EXPECT_EQ(check.agrees, stage == 0 && number == 2 * source_count);
      ++tried;
    }
  EXPECT_EQ(tried, 5);
}

// Two trajectories that part as exp(10 t): the horizon is where they are 0.5 % of the size apart.
TEST(ReferenceCheck, AHorizonIsFoundWhereTheReferenceParts) {
  const Mesh mesh = box(ElementKind::tet4, 1);
  const SamplePoints points = sample_points(System(of_mesh(mesh)));
  const Trajectory still = seen(mesh, points, linear_field);
  Trajectory a, b;
  a.dimension = b.dimension = 3;
  for (int k = 1; k <= 100; ++k) {
    a.t.push_back(0.01 * k);
    a.x.push_back(still.x[0]);
    b.t.push_back(0.01 * k);
    b.x.push_back(still.x[0] + Eigen::VectorXd::Constant(still.x[0].size(), 2e-6 * std::exp(0.1 * k) / std::sqrt(3.0)));
  }
  const ReferenceCheck check = check_reference({a, b, a, b}, points);
  EXPECT_TRUE(check.diverges);
  EXPECT_NEAR(check.horizon, std::log(5e-3 / 1e-6) / 10, 0.011);
}

}  // namespace
}  // namespace sim
