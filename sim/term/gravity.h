// Gravity: U = -sum_i m_i g . (x_i - X_i). Measured from rest, so that a body far from the origin loses no digits.
#pragma once

#include "sim/body/mass.h"
#include "sim/term/term.h"

namespace sim {

class Gravity final : public Term {
 public:
  // masses and X (rest positions) must outlive the term.
  Gravity(const Vec3& g, const std::vector<Mass>& masses, const Eigen::VectorXd& X, int D);

  TermInfo info() const override;
  Role role() const override { return Role::own; }
  std::optional<double> dead_ramp() const override { return 0; }
  double energy(const Motion& motion, Store&) const override;
  void add_forces(const Motion& motion, Store&, Eigen::VectorXd& f) const override;

 private:
  Eigen::VectorXd weight_;  // m_i g, D numbers per node [N]
  const Eigen::VectorXd& X_;
  Vec3 g_;
};

}  // namespace sim
