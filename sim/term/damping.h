// Rayleigh damping of one body: f = -(alpha M + beta K) v, K frozen and clamped where the step began. [mathematics.md
// 6] With v = (x - x*)/(g h) inside a stage it is the gradient of the potential g h/2 v^T (alpha M + beta K) v.
#pragma once

#include <vector>

#include "sim/body/mass.h"
#include "sim/scene.h"
#include "sim/term/elastic.h"

namespace sim {

class RayleighDamping final : public Term {
 public:
  // The mass and the elastic terms of the body must outlive the term.
  RayleighDamping(const Body& body, const Mass& mass, std::vector<const ElasticTerm*> elastic, int D);

  TermInfo info() const override;
  Role role() const override { return Role::own; }
  std::unique_ptr<Store> make_store(int threads) const override;
  void begin_step(const Motion& start, Store& store) const override;
  bool lags() const override { return damping_.beta > 0; }
  double energy(const Motion& motion, Store& store) const override;
  void add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const override;
  void linearise(const Motion& motion, Definiteness, Store& store, Eigen::VectorXd& f) const override;
  void add_product(const Store& store, double s, const Eigen::VectorXd& p, Eigen::VectorXd& y) const override;
  void add_matrix(const Store& store, double s, BlockMatrix& A) const override;
  void add_diagonal(const Store& store, double s, Eigen::VectorXd& d) const override;

 private:
  struct Frozen;
  std::string body_;
  Damping damping_;
  const Mass& mass_;
  std::vector<const ElasticTerm*> elastic_;
  int D_;
};

}  // namespace sim
