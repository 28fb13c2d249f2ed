// A term of the potential energy U(x): the one interface behind which every effect of a scene stands.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "sim/material/tangent.h"
#include "sim/math/block_matrix.h"
#include "sim/report.h"

namespace sim {

// Where and when a term is evaluated. Inside a stage v = (x - x*)/(g h), so dv/dx = dv_dx.
struct Motion {
  const Eigen::VectorXd& x;  // m
  const Eigen::VectorXd& v;  // m/s
  double t = 0;              // s
  double dv_dx = 0;          // 1/(g h) [1/s]; 0 where v does not follow x (explicit, static)
  double barriers = 1;       // how often the sum of all terms counts barriers there: Stage::barriers, 0 without them
};

// What a term stands for: the body's own elasticity, an effect of its motion or place (weight, damping, untangling), or
// a load that acts on it from outside.
enum class Role { elastic, own, applied };

class Term {
 public:
  // The scratch of a term: its latest linearisation, and what it froze when the step began. One for each stepper.
  struct Store {
    virtual ~Store() = default;
    int threads = 1;
  };

  virtual ~Term() = default;
  virtual TermInfo info() const = 0;
  virtual Role role() const = 0;

  virtual std::unique_ptr<Store> make_store(int threads) const {
    auto store = std::make_unique<Store>();
    store->threads = threads;
    return store;
  }
  // Freezes what a term keeps fixed during a step (damping's tangent, friction's normal forces).
  virtual void begin_step(const Motion& /*start*/, Store&) const {}
  // Of a dead load, whose force depends on time alone: the ramp [s] on which it rises (sim/term/ramp.h).
  virtual std::optional<double> dead_ramp() const { return {}; }
  // Its friction drags what touches it, at time t: it moves, even where no node does, as a plane that turns in itself.
  virtual bool drives(double /*t*/) const { return false; }
  // It freezes something.
  virtual bool lags() const { return false; }

  // U [J]; +infinity where the term does not allow x.
  virtual double energy(const Motion& motion, Store& store) const = 0;
  // f += -dU/dx [N]
  virtual void add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const = 0;

  // f += -dU/dx, and keeps K = d2U/dx2 (made definite) in the store for the two below.
  virtual void linearise(const Motion& motion, Definiteness, Store& store, Eigen::VectorXd& f) const {
    add_forces(motion, store, f);
  }
  // y += s K p, without a matrix
  virtual void add_product(const Store&, double /*s*/, const Eigen::VectorXd& /*p*/, Eigen::VectorXd& /*y*/) const {}
  // A += s K, the blocks (i, j) with i <= j (BlockMatrix::mirror makes the others)
  virtual void add_matrix(const Store&, double /*s*/, BlockMatrix& /*A*/) const {}
  // d += s diag(K)
  virtual void add_diagonal(const Store&, double /*s*/, Eigen::VectorXd& /*d*/) const {}

  // Which nodes K couples, and then where their blocks lie: called once while the system is built.
  virtual void couple(Coupling&) const {}
  virtual void bind(const BlockPattern&) {}

  // Pairs (i, j), i < j, of the last linearisation's K that couple() could not name: bodies that touch.
  virtual void add_pairs(const Store&, std::vector<NodePair>&) const {}

  // It is a barrier: it does not allow every x.
  virtual bool limits_moves() const { return false; }
  // The largest a <= 1 for which x + a dx is allowed, and all before it.
  virtual double largest_step(const Motion&, const Eigen::VectorXd& /*dx*/, Store&) const { return 1; }
};

}  // namespace sim
