// A plane or a sphere that no surface passes: a barrier on its distance from every patch, and friction. [Li et al.
// 2020]
//   U = sum_i kappa A_i b(d_i), patches and d as in sim/contact/approach.h, b as in sim/contact/barrier.h
// Friction opposes the tangential velocity with mu lambda_i f1(|v_T|), lambda_i the normal force when the step began,
// f1 rising smoothly from 0 to 1 at the speed eps: the gradient of a potential in v, so it works in every stage.
// What moves has nodes whose positions are prescribed: on its straight way within a step, nothing passes it either. The
// velocity that friction counts from is that of the obstacle at the place that was touched when the step began.
#pragma once

#include <array>
#include <variant>
#include <vector>

#include "sim/body/obstacle_nodes.h"
#include "sim/contact/approach.h"
#include "sim/term/term.h"

namespace sim {

class ObstacleTerm final : public Term {
 public:
  // A patch that may touch: its nodes in the system, and kappa times its area [N]. dh [m]: where the barrier begins;
  // eps [m/s]: where friction is fully grown.
  struct Contact {
    std::array<int, 3> node;
    int count;
    double kappa;
  };
  using Shape = std::variant<Plane, Sphere>;
  // The obstacle is a plane or a sphere; patches are nodes for the one and faces for the other.
  ObstacleTerm(const Obstacle& obstacle, const ObstacleNodes& nodes, std::vector<Contact> contacts, double dh,
               double eps, int D);

  TermInfo info() const override;
  Role role() const override { return Role::applied; }
  std::unique_ptr<Store> make_store(int threads) const override;
  void begin_step(const Motion& start, Store& store) const override;
  bool lags() const override { return obstacle_.friction > 0; }
  double energy(const Motion& motion, Store& store) const override;
  void add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const override;
  void linearise(const Motion& motion, Definiteness fix, Store& store, Eigen::VectorXd& f) const override;
  void add_product(const Store& store, double s, const Eigen::VectorXd& p, Eigen::VectorXd& y) const override;
  void add_matrix(const Store& store, double s, BlockMatrix& A) const override;
  void add_diagonal(const Store& store, double s, Eigen::VectorXd& d) const override;
  void couple(Coupling& coupling) const override;
  void bind(const BlockPattern& pattern) override;
  bool drives(double t) const override;
  bool limits_moves() const override { return true; }
  double largest_step(const Motion& motion, const Eigen::VectorXd& dx, Store&) const override;

  // Where it is when the nodes of the system are at x.
  Shape shape(const Eigen::VectorXd& x) const;
  Patch patch(const Eigen::VectorXd& x, const Contact& contact) const;
  const std::vector<Contact>& contacts() const { return contacts_; }
  // A node of the patch that is nearest, and how near: its gap [m], of the distance at which the barrier begins.
  struct Nearest {
    int node = -1;
    double gap, share;
  };
  Nearest nearest(const Eigen::VectorXd& x, double t) const;
  const Obstacle& obstacle() const { return obstacle_; }

 private:
  struct Touched;
  struct Grip;
  bool is_gone(double t) const { return obstacle_.release && t > *obstacle_.release; }
  Vec3 slip(const Motion& motion, const Grip& grip) const;
  void scatter(const Contact& contact, const PairVector& force, Eigen::VectorXd& f) const;

  Obstacle obstacle_;
  ObstacleNodes nodes_;
  std::vector<Contact> contacts_;
  double dh_, eps_;
  int D_;
  std::vector<std::array<int, 6>> slots_;  // of each contact's pairs of nodes, upper half row by row
};

// Signed distance [m] of a patch, positive outside.
double gap(const ObstacleTerm::Shape& shape, const Patch& at);

}  // namespace sim
