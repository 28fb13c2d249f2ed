// A dead load on reduced coordinates: U = -s(t) g . c, with g = U^T f of the load as it is when it has risen.
#pragma once

#include <utility>

#include "sim/term/term.h"

namespace sim {

class DeadLoad final : public Term {
 public:
  DeadLoad(TermInfo info, Eigen::VectorXd force, double ramp)
      : info_(std::move(info)), force_(std::move(force)), ramp_(ramp) {}

  TermInfo info() const override { return info_; }
  Role role() const override { return Role::applied; }
  std::optional<double> dead_ramp() const override { return ramp_; }
  double energy(const Motion& motion, Store&) const override;
  void add_forces(const Motion& motion, Store&, Eigen::VectorXd& f) const override;

 private:
  TermInfo info_;
  Eigen::VectorXd force_;
  double ramp_;  // s
};

}  // namespace sim
