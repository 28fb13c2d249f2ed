// A spring between a material point and a place in space: U = k/2 |x_p - target|^2. A handle, or the pull of a mouse.
#pragma once

#include "sim/mesh/locate.h"
#include "sim/scene.h"
#include "sim/term/term.h"

namespace sim {

class SpringTerm final : public Term {
 public:
  // nodes: of the system; the point is sum_a weights[a] x_(nodes[a]).
  SpringTerm(const Spring& spring, std::vector<int> nodes, std::vector<double> weights, int D);

  TermInfo info() const override;
  Role role() const override { return Role::applied; }
  double energy(const Motion& motion, Store&) const override;
  void add_forces(const Motion& motion, Store&, Eigen::VectorXd& f) const override;
  void add_product(const Store&, double s, const Eigen::VectorXd& p, Eigen::VectorXd& y) const override;
  void add_matrix(const Store&, double s, BlockMatrix& A) const override;
  void add_diagonal(const Store&, double s, Eigen::VectorXd& d) const override;
  void couple(Coupling& coupling) const override { coupling.add(nodes_); }
  void bind(const BlockPattern& pattern) override;

 private:
  Vec3 point(const Eigen::VectorXd& x) const;

  Spring spring_;
  std::vector<int> nodes_;
  std::vector<double> weights_;
  int D_;
  std::vector<int> slot_;
};

}  // namespace sim
