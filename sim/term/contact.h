// Contact between deformable bodies, and of a body with itself: no primitive of their surfaces passes another.
//   U = sum over pairs kappa A m M b(d): sim/contact/touch.h, barrier.h, mollifier.h
// Friction opposes the slip of each pair with mu lambda f1(|slip|), with lambda, normal and closest points as they were
// when the step began: U_f = mu lambda f0(|T sum_i c_i v_i|) g h. [Li et al. 2020]
// Which pairs may come near each other is found for a whole way at once, before a step along it is limited; energies
// and tangents on that way look at no others.
// A surface of an obstacle is one of the surfaces. Its nodes are prescribed: they are in the product with a
// displacement, which may move them, but in no matrix.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "sim/contact/contact_report.h"
#include "sim/contact/nearness.h"
#include "sim/contact/stick.h"
#include "sim/contact/touch.h"
#include "sim/term/term.h"

namespace sim {

class ContactTerm final : public Term {
 public:
  struct Input {
    std::string name;  // of the two sides
    Skin skin;
    std::vector<Couple> couples;
    double friction = 0;                                       // Coulomb's coefficient
    double eps = 0;                                            // m/s: where friction is fully grown
    std::vector<std::string> names;                            // of the skin's parts
    int first_given = std::numeric_limits<int>::max();         // nodes from it on are an obstacle's
    double release = std::numeric_limits<double>::infinity();  // s: it is not there after that
  };
  // X: rest positions of the system
  ContactTerm(Input input, const Eigen::VectorXd& X);

  TermInfo info() const override;
  Role role() const override { return Role::applied; }
  std::unique_ptr<Store> make_store(int threads) const override;
  void begin_step(const Motion& start, Store& store) const override;
  bool lags() const override { return in_.friction > 0; }
  double energy(const Motion& motion, Store& store) const override;
  void add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const override;
  void linearise(const Motion& motion, Definiteness fix, Store& store, Eigen::VectorXd& f) const override;
  void add_product(const Store& store, double s, const Eigen::VectorXd& p, Eigen::VectorXd& y) const override;
  void add_matrix(const Store& store, double s, BlockMatrix& A) const override;
  void add_diagonal(const Store& store, double s, Eigen::VectorXd& d) const override;
  void add_pairs(const Store& store, std::vector<NodePair>& pairs) const override;
  // Every pair of bodies at a motion: for the eye. Friction is that of a step that began there.
  std::vector<ContactReport> reports(const Motion& begin, const Motion& motion) const;
  // The two that are nearest each other, if any are near.
  Nearness nearest(const Eigen::VectorXd& x, double t) const;
  const Input& input() const { return in_; }

  bool limits_moves() const override { return true; }
  double largest_step(const Motion& motion, const Eigen::VectorXd& dx, Store& store) const override;

 private:
  struct Contacts;
  void place(const Eigen::VectorXd& x, Contacts& s) const;
  void cover(Contacts& s) const;
  bool find_touches(const Motion& motion, Contacts& s) const;
  bool is_gone(double t) const { return t > in_.release; }
  void scatter(const std::array<int, 4>& points, int count, const PairVector& force, Eigen::VectorXd& f) const;
  Vec3 on_first(const Couple& couple, const std::array<int, 4>& points, int count, const PairVector& force) const;
  double area_of(const Candidate& candidate, Contacts& s) const;
  Vec3 slip(const Stick& stick, const Eigen::VectorXd& v) const;

  Input in_;
  BroadPhase broad_phase_;
  double reach_;  // m: the largest dh + xi
};

}  // namespace sim
