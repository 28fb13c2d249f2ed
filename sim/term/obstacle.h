// A plane or a sphere that no surface node passes: a barrier on its distance, and friction. [Li et al. 2020]
//   U = sum_i kappa A_i b(d_i), b as in sim/contact/barrier.h
// Friction opposes the tangential velocity with mu lambda_i f1(|v_T|), lambda_i the normal force when the step began,
// f1 rising smoothly from 0 to 1 at the speed eps: the gradient of a potential in v, so it works in every stage.
// What moves has nodes whose positions are prescribed: on its straight way within a step, nothing passes it either. The
// velocity that friction counts from is that of the obstacle at the place where the node was when the step began.
#pragma once

#include <variant>
#include <vector>

#include "sim/body/obstacle_nodes.h"
#include "sim/term/term.h"

namespace sim {

class ObstacleTerm final : public Term {
 public:
  // Nodes that may touch: number in the system, and kappa times their share of the surface [N]; dh [m]: where the
  // barrier begins; eps [m/s]: where friction is fully grown.
  struct Contact {
    int node;
    double kappa;
  };
  using Shape = std::variant<Plane, Sphere>;
  // The obstacle is a plane or a sphere.
  ObstacleTerm(const Obstacle& obstacle, const ObstacleNodes& nodes, std::vector<Contact> contacts, double dh,
               double eps, int D);

  TermInfo info() const override;
  Role role() const override { return Role::applied; }
  std::unique_ptr<Store> make_store(int threads) const override;
  void begin_step(const Motion& start, Store& store) const override;
  bool lags() const override { return obstacle_.friction > 0; }
  double energy(const Motion& motion, Store& store) const override;
  void add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const override;
  void linearise(const Motion& motion, Definiteness, Store& store, Eigen::VectorXd& f) const override;
  void add_product(const Store& store, double s, const Eigen::VectorXd& p, Eigen::VectorXd& y) const override;
  void add_matrix(const Store& store, double s, BlockMatrix& A) const override;
  void add_diagonal(const Store& store, double s, Eigen::VectorXd& d) const override;
  void bind(const BlockPattern& pattern) override;
  bool limits_moves() const override { return true; }
  double largest_step(const Motion& motion, const Eigen::VectorXd& dx, Store&) const override;

  // Where it is when the nodes of the system are at x.
  Shape shape(const Eigen::VectorXd& x) const;
  // The node that is nearest, and how near: its gap [m], of the distance at which the barrier begins.
  struct Nearest {
    int node = -1;
    double gap, share;
  };
  Nearest nearest(const Eigen::VectorXd& x, double t) const;
  const Obstacle& obstacle() const { return obstacle_; }

 private:
  struct Blocks;
  Vec3 at(const Eigen::VectorXd& x, int node) const;
  bool is_gone(double t) const { return obstacle_.release && t > *obstacle_.release; }
  Vec3 slip(const Motion& motion, const Blocks& s, std::size_t k) const;

  Obstacle obstacle_;
  ObstacleNodes nodes_;
  std::vector<Contact> contacts_;
  double dh_, eps_;
  int D_;
  std::vector<int> slot_;  // diagonal block of each contact's node
};

// Signed distance [m] of a point, positive outside, and its gradient.
double distance(const ObstacleTerm::Shape& shape, const Vec3& x, Vec3& normal);

}  // namespace sim
