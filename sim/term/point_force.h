// A dead load at a material point: U = -s(t) F . (x - X) there.
#pragma once

#include <vector>

#include "sim/scene.h"
#include "sim/term/term.h"

namespace sim {

class PointLoad final : public Term {
 public:
  // The point is the weighted sum of nodes of the system.
  PointLoad(const std::string& body, const PointForce& force, std::vector<int> nodes, std::vector<double> weights,
            int D);

  TermInfo info() const override;
  Role role() const override { return Role::applied; }
  std::optional<double> dead_ramp() const override { return force_.ramp; }
  double energy(const Motion& motion, Store&) const override;
  void add_forces(const Motion& motion, Store&, Eigen::VectorXd& f) const override;

 private:
  std::string body_;
  PointForce force_;
  std::vector<int> nodes_;
  std::vector<double> weights_;
  int D_;
};

}  // namespace sim
