// A dead load on boundary facets: U = -s(t) sum_facets int N_i T . (x_i - X_i) dA, T per rest area [Pa].
// s(t) rises smoothly from 0 to 1 over the ramp (sim/term/ramp.h).
#pragma once

#include "sim/scene.h"
#include "sim/term/term.h"

namespace sim {

class TractionLoad final : public Term {
 public:
  // facets: nodes per facet x facets, numbers in the body's mesh; those of a membrane's elements are its faces. X (rest
  // positions) must outlive the term.
  TractionLoad(const Body& body, const Traction& traction, const Eigen::MatrixXi& facets, int first_node,
               const Eigen::VectorXd& X, int D);

  TermInfo info() const override;
  Role role() const override { return Role::applied; }
  std::optional<double> dead_ramp() const override { return traction_.ramp; }
  double energy(const Motion& motion, Store&) const override;
  void add_forces(const Motion& motion, Store&, Eigen::VectorXd& f) const override;

 private:
  template <class Facet, int Dim>
  void add_load(const Body& body, const Eigen::MatrixXi& facets, double thickness, int first_node, int D);

  std::string body_;
  Traction traction_;
  double area_ = 0;       // m^2
  Eigen::VectorXd load_;  // N at full load, D numbers per node of the system
  const Eigen::VectorXd& X_;
};

}  // namespace sim
