// A pressure that follows the surface: f_a = -p s(t) int N_a n dA over the facets as they are, n their outward normal;
// of a membrane, pressure acts along the normal of its faces, and from inside where it is closed. U = +-p s(t) (V(x) -
// V(X)), V what lies between the facets and a point near by (sim/term/enclosed.h): over a closed surface, and up to a
// rim that is held, the force is -dU/dx. At a free rim it has no potential; there the difference is that of the step's
// beginning, which solver.lag_iterations renew.
#pragma once

#include <string>
#include <vector>

#include "sim/scene.h"
#include "sim/term/term.h"

namespace sim {

class PressureLoad final : public Term {
 public:
  // facets: nodes per facet x facets, numbers in the body's mesh; X: rest positions of the system. Throws InputError
  // (key "value") where a closed membrane does not face one way.
  PressureLoad(const Body& body, const Pressure& pressure, const Eigen::MatrixXi& facets, int first_node,
               const Eigen::VectorXd& X, int D);

  TermInfo info() const override;
  Role role() const override { return Role::applied; }
  std::unique_ptr<Store> make_store(int threads) const override;
  void begin_step(const Motion& start, Store& store) const override;
  bool lags() const override { return open_; }
  double energy(const Motion& motion, Store& store) const override;
  void add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const override;
  void linearise(const Motion& motion, Definiteness fix, Store& store, Eigen::VectorXd& f) const override;
  void add_product(const Store& store, double s, const Eigen::VectorXd& p, Eigen::VectorXd& y) const override;
  void add_matrix(const Store& store, double s, BlockMatrix& A) const override;
  void add_diagonal(const Store& store, double s, Eigen::VectorXd& d) const override;
  void couple(Coupling& coupling) const override;
  void bind(const BlockPattern& pattern) override;

 private:
  struct Kept;
  template <class F>
  void visit(const F& f) const;
  double strength(double t) const;                // Pa, along the facets' normals; in the plane Pa m
  double volume(const Eigen::VectorXd& x) const;  // between the facets and the origin, m^3; in the plane m^2
  template <class Facet, int D>
  Eigen::Matrix<double, D, Facet::nodes> gathered(const Eigen::VectorXd& x, Eigen::Index facet) const;
  void orient(const Body& body, const Eigen::VectorXd& X);
  void turn_outwards(ElementKind kind, const std::vector<char>& at_rim, const Eigen::VectorXd& X);

  std::string body_;
  Pressure pressure_;
  Eigen::MatrixXi facets_;  // numbers in the system
  int D_;
  bool open_ = false;        // it has a rim
  Vec3 origin_ = {0, 0, 0};  // m, that V counts from: near by, so that its last digits count
  int sign_ = -1;            // of the force along the facets' normals
  double thickness_ = 1;     // m, in the plane
  double area_ = 0;          // m^2 at rest
  double rest_volume_ = 0;   // as volume()
  std::vector<int> slot_;    // blocks (a, b) of each facet
};

}  // namespace sim
