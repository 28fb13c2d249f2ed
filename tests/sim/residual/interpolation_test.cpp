// Interpolation and its order, with the shape functions of every plane element.
#include "sim/study/interpolation.h"

#include <gtest/gtest.h>

#include <numbers>

#include "sim/element/list.h"
#include "sim/mesh/generate.h"
#include "sim/mesh/geometry.h"
#include "tests/sim/residual/problems.h"

namespace sim {
namespace {

// sin(pi x) e^y
PlaneFunction wave() {
  const double pi = std::numbers::pi;
  return {[pi](const Eigen::Vector2d& X) { return std::sin(pi * X[0]) * std::exp(X[1]); },
          [pi](const Eigen::Vector2d& X) {
            return Eigen::Vector2d(pi * std::cos(pi * X[0]) * std::exp(X[1]), std::sin(pi * X[0]) * std::exp(X[1]));
          }};
}

InterpolationError error_on(const ElementInfo& element, int n) {
  return interpolation_error(generate_rectangle({1, 1}, {n, n}, {1, 1}, element.kind), wave());
}

TEST(Interpolation, ErrorsAreThoseOfTheTable) {
  const auto rows = test::rows_of("interpolation.csv");
  ASSERT_EQ(rows.size(), 12u);
  for (const auto& row : rows) {
    const InterpolationError error = error_on(*find_element(row[1]), std::stoi(row[2]));
    EXPECT_NEAR(error.L2 / std::stod(row[3]), 1, 1e-8) << row[1] << row[2];
    EXPECT_NEAR(error.H1_seminorm / std::stod(row[4]), 1, 1e-8) << row[1] << row[2];
    EXPECT_NEAR(error.max / std::stod(row[5]), 1, 1e-8) << row[1] << row[2];
  }
}

TEST(Interpolation, FallsByTheOrderOfTheElementAndOneMore) {
  for (const char* const name : {"tri3", "tri6", "quad4"}) {
    const ElementInfo& element = *find_element(name);
    const InterpolationError coarse = error_on(element, 8), fine = error_on(element, 16);
    EXPECT_NEAR(std::log2(coarse.L2 / fine.L2), element.order + 1, 0.02) << name;
    EXPECT_NEAR(std::log2(coarse.H1_seminorm / fine.H1_seminorm), element.order, 0.02) << name;
  }
}

TEST(Interpolation, OfAPolynomialOfTheElementIsExact) {
  const PlaneFunction plane = {[](const Eigen::Vector2d& X) { return 1 + 2 * X[0] - 3 * X[1]; },
                               [](const Eigen::Vector2d&) { return Eigen::Vector2d(2, -3); }};
  for (const char* const name : {"tri3", "tri6", "quad4"}) {
    const Mesh mesh = generate_rectangle({2, 1}, {3, 2}, {1.5, 1}, find_element(name)->kind);
    const InterpolationError error = interpolation_error(mesh, plane);
    EXPECT_LT(error.L2 + error.H1_seminorm + error.max, 1e-13) << name;
  }
}

// Numbers of a separate program, ten digits.
template <class E>
void expect_shape(const ElementX<E, 2>& X_e, const std::array<double, 2>& xi, const std::array<double, E::nodes>& N,
                  const Eigen::Matrix<double, E::nodes, 2>& dN_dX, double det_J) {
  const Jacobian<E, 2> J = jacobian<E, 2>(X_e, xi);
  EXPECT_NEAR(J.determinant(), det_J, 1e-9);
  const auto found = E::N(xi);
  const auto dN = E::dN(xi);
  for (int i = 0; i < E::nodes; ++i) {
    EXPECT_NEAR(found[i], N[i], 1e-9) << E::name << i;
    const Eigen::RowVector2d slope = Eigen::RowVector2d(dN[i][0], dN[i][1]) * J.inverse();
    EXPECT_NEAR((slope - dN_dX.row(i)).norm(), 0, 1e-9) << E::name << i;
  }
}

TEST(Interpolation, ShapeFunctionsAtAPointAreThoseOfTheTable) {
  ElementX<Tri3, 2> triangle;
  triangle << 0, 2, 0.5, 0, 0, 1.5;
  Eigen::Matrix<double, 3, 2> linear;
  linear << -0.5, -0.5, 0.5, -0.1666666667, 0, 0.6666666667;
  expect_shape<Tri3>(triangle, {0.2, 0.5}, {0.3, 0.2, 0.5}, linear, 3);

  ElementX<Tri6, 2> curved;
  curved << 0, 2, 0.5, 1, 1.25, 0.25, 0, 0, 1.5, 0, 0.75, 0.75;
  Eigen::Matrix<double, 6, 2> quadratic;
  quadratic << -0.1, -0.1, -0.1, 0.03333333333, 0, 0.6666666667, 0.2, -0.6, 1, 0.2, -1, -0.2;
  expect_shape<Tri6>(curved, {0.2, 0.5}, {-0.12, -0.12, 0, 0.24, 0.4, 0.6}, quadratic, 3);

  ElementX<Quad4, 2> quad;
  quad << 0, 2, 1.7, 0.2, 0, 0.2, 1.5, 1.1;
  Eigen::Matrix<double, 4, 2> bilinear;
  bilinear << -0.3336221837, -0.318457539, 0.4462738302, -0.483102253, 0.08665511265, 0.5372616984, -0.1993067591,
      0.2642980936;
  expect_shape<Quad4>(quad, {0.3, -0.4}, {0.245, 0.455, 0.195, 0.105}, bilinear, 0.577);
}

}  // namespace
}  // namespace sim
