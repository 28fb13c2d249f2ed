// A way out of states that elasticity alone does not leave: a body folded through itself, or with elements that are
// stuck inside out. While a connected part of it is tangled (sim/mesh/tangle.h) when a step begins, each node i is
// drawn to its place g_i in the rest shape, moved rigidly to where the part is:
//   U = sum_i k_i/2 |x_i - g_i|^2,  g_i = R X_i + c(t),  k_i = s sum_e E_e V_e/l_e^2/n_e
// l_e the size of an element, n_e its nodes, s the strength; R fits best when the step begins. [after shape matching,
// Mueller et al. 2005] A part that is not tangled feels nothing. Pinned nodes lead the fit; a part that has none gets
// hardly any momentum, by its c(t): what elements hold is not counted in that.
//
// Nodes are drawn over distances of the body's size within a step, on ways that no scheme resolves. A second stage, or
// a force from before, would make a spin of many radians a step out of them, which the scheme sustains: so such a step
// is one of backward Euler, x x M v of whose end is that of its start. [time/implicit.cpp]
#pragma once

#include <span>
#include <vector>

#include "sim/body/pins.h"
#include "sim/mesh/tangle.h"
#include "sim/scene.h"
#include "sim/term/term.h"

namespace sim {

class UntangleTerm final : public Term {
 public:
  // material: of each element, a number in body.materials. X: rest positions of the system; the pins must outlive the
  // term.
  UntangleTerm(const Body& body, const std::vector<int>& material, int first_node, const Eigen::VectorXd& X,
               const Pins& pins, int D);

  // In the step that has begun with these stores, of all terms, something is drawn.
  static bool draws(std::span<const std::unique_ptr<Store>> stores);

  TermInfo info() const override;
  Role role() const override { return Role::own; }
  std::unique_ptr<Store> make_store(int threads) const override;
  void begin_step(const Motion& start, Store& store) const override;
  bool lags() const override { return true; }
  double energy(const Motion& motion, Store& store) const override;
  void add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const override;
  void add_product(const Store& store, double s, const Eigen::VectorXd& p, Eigen::VectorXd& y) const override;
  void add_matrix(const Store& store, double s, BlockMatrix& A) const override;
  void add_diagonal(const Store& store, double s, Eigen::VectorXd& d) const override;
  void bind(const BlockPattern& pattern) override;

 private:
  struct Goals;
  struct Part {
    std::vector<int> nodes;  // of the body
    Tangle tangle;
  };
  void aim(std::size_t part, Goals& goals) const;
  void place(double t, Goals& goals) const;
  // Of the body's nodes; p has three numbers for each, the third 0 in 2D.
  void take(const Eigen::VectorXd& x, Eigen::Matrix3Xd& p) const;
  // Calls f(node of the body, its first component in the system) for the nodes that are drawn.
  template <class F>
  void for_each_drawn(const Goals& goals, const F& f) const;

  std::string body_;
  double strength_;
  int first_node_, D_;
  Eigen::Index dofs_;  // of the system
  Eigen::Matrix3Xd X_;
  Eigen::VectorXd k_;     // N/m
  Eigen::VectorXd mass_;  // kg
  const Pins& pins_;
  std::vector<Part> parts_;
  std::vector<int> slot_;
};

}  // namespace sim
