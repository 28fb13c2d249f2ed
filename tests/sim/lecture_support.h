// The lecture's numbers that another program computed (tests/data/lecture, README.md there), and bodies of one element.
#pragma once

#include "tests/sim/json.h"
#include "tests/sim/stepping.h"

namespace sim::test {

inline constexpr double digits = 1e-8;

// Equal to 1e-8 of the largest entry.
inline void expect_near(const Eigen::MatrixXd& found, const Eigen::MatrixXd& reference, const std::string& what) {
  ASSERT_EQ(found.rows(), reference.rows()) << what;
  ASSERT_EQ(found.cols(), reference.cols()) << what;
  const double scale = std::max(reference.cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((found - reference).cwiseAbs().maxCoeff(), digits * scale) << what << "\n" << found << "\n" << reference;
}

// A body of one element with these rest positions (rows).
inline Body single(const Eigen::MatrixXd& X_rows, const std::string& model, double young, double poisson) {
  Body body;
  body.mesh.kind = X_rows.cols() == 2 ? ElementKind::tri3 : ElementKind::tet4;
  body.mesh.X = X_rows.transpose();
  body.mesh.elements.resize(X_rows.rows(), 1);
  for (int a = 0; a < X_rows.rows(); ++a) body.mesh.elements(a, 0) = a;
  body.materials = {MaterialSpec{model, young, poisson, 1000, ""}};
  return body;
}

}  // namespace sim::test
