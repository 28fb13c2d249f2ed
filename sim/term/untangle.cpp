#include "sim/term/untangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "sim/math/rigid_fit.h"
#include "sim/mesh/geometry.h"

namespace sim {

namespace {

// Of the elements at each node: sum_e E_e V_e/l_e^2/n_e [N/m], l_e^dimension the element's measure, and their shares of
// the mass [kg].
struct NodalSums {
  Eigen::VectorXd stiffness, mass;
};

NodalSums nodal_sums(const Body& body, const std::vector<int>& material) {
  const Mesh& mesh = body.mesh;
  NodalSums sums{Eigen::VectorXd::Zero(mesh.node_count()), Eigen::VectorXd::Zero(mesh.node_count())};
  visit_mesh(mesh, [&]<class E, int D>(std::type_identity<E>, std::integral_constant<int, D>) {
    const double across = E::dimension == 2 ? body.thickness : 1;
    for (int e = 0; e < mesh.element_count(); ++e) {
      const double V = measure<E, D>(gather<E, D>(mesh.X, mesh.elements.col(e).data()), E::rule);
      const MaterialSpec& of = body.materials[material[e]];
      for (const int node : mesh.elements.col(e)) {
        sums.stiffness[node] += of.young * across * std::pow(V, 1 - 2.0 / E::dimension) / E::nodes;
        sums.mass[node] += of.density * across * V / E::nodes;
      }
    }
  });
  return sums;
}

}  // namespace

// Of the nodes of the body: whether and where each is drawn.
struct UntangleTerm::Goals : Store {
  double t = 0;  // s, when the step began
  std::vector<bool> drawn;
  Eigen::Matrix3Xd fitted;  // m: by the rotation that fits best, and some translation
  Eigen::Matrix3Xd x, v;    // m, m/s, where the step began
  Eigen::VectorXd weight;   // N/m, of a node in the fit
  std::vector<bool> part_drawn, part_pinned;
  double placed_at = 0;    // s: the time that `place` is for
  Eigen::Matrix3Xd place;  // m
  Eigen::VectorXd free;    // of the system, for a look at the pins
};

UntangleTerm::UntangleTerm(const Body& body, const std::vector<int>& material, int first_node, const Eigen::VectorXd& X,
                           const Pins& pins, int D)
    : body_(body.name),
      strength_(body.untangle),
      first_node_(first_node),
      D_(D),
      dofs_(X.size()),
      X_(Eigen::Matrix3Xd::Zero(3, body.mesh.node_count())),
      pins_(pins) {
  NodalSums sums = nodal_sums(body, material);
  k_ = strength_ * sums.stiffness;
  mass_ = std::move(sums.mass);
  take(X, X_);
  for (Component& part : components(body.mesh)) {
    Tangle tangle(body.mesh, part, first_node, D);
    parts_.push_back({std::move(part.nodes), std::move(tangle)});
  }
}

TermInfo UntangleTerm::info() const {
  std::ostringstream what;
  what << "strength " << strength_ << ", where folded or inside out";
  return {"untangle " + body_, what.str()};
}

std::unique_ptr<Term::Store> UntangleTerm::make_store(int threads) const {
  auto store = std::make_unique<Goals>();
  store->threads = threads;
  store->drawn.assign(X_.cols(), false);
  store->fitted = store->place = store->x = store->v = Eigen::Matrix3Xd::Zero(3, X_.cols());
  store->part_drawn.assign(parts_.size(), false);
  store->part_pinned.assign(parts_.size(), false);
  store->free.resize(dofs_);
  store->weight.resize(X_.cols());
  return store;
}

void UntangleTerm::take(const Eigen::VectorXd& x, Eigen::Matrix3Xd& p) const {
  p.topRows(D_) = x.segment(static_cast<Eigen::Index>(first_node_) * D_, X_.cols() * D_).reshaped(D_, X_.cols());
}

void UntangleTerm::aim(std::size_t number, Goals& goals) const {
  constexpr double lead = 1e3;  // of a pinned node, times its weight
  const Part& part = parts_[number];
  goals.part_drawn[number] = true;
  for (const int i : part.nodes) {
    goals.drawn[i] = true;
    const bool pinned = goals.free.segment(static_cast<Eigen::Index>(first_node_ + i) * D_, D_).minCoeff() == 0;
    goals.weight[i] = pinned ? lead * k_[i] : k_[i];
    if (pinned) goals.part_pinned[number] = true;
  }
  const RigidFit fit = fit_rigid(X_, goals.x, goals.weight, part.nodes, D_);
  for (const int i : part.nodes) goals.fitted.col(i) = fit.place(X_.col(i));
}

void UntangleTerm::begin_step(const Motion& start, Store& store) const {
  auto& goals = static_cast<Goals&>(store);
  goals.t = start.t;
  goals.placed_at = std::numeric_limits<double>::quiet_NaN();
  goals.drawn.assign(goals.drawn.size(), false);
  goals.part_drawn.assign(parts_.size(), false);
  goals.part_pinned.assign(parts_.size(), false);
  pins_.mark(start.t, goals.free);
  take(start.x, goals.x);
  take(start.v, goals.v);
  for (std::size_t k = 0; k < parts_.size(); ++k)
    if (parts_[k].tangle.count(start.x).any()) aim(k, goals);
}

// g_i at time t. Where a part is free, the springs must give it no momentum: sum_i k_i (x_i - g_i) = 0 at the step's
// end. A node of mass m_i that its spring alone draws for a time dt goes by k_i dt^2/(m_i + k_i dt^2) of its way, so
// what its spring then holds is that of k_i and m_i/dt^2 one behind the other,
//   sum_i kappa_i (x_i + dt v_i - g_i) = 0,   1/kappa_i = 1/k_i + dt^2/m_i
void UntangleTerm::place(double t, Goals& goals) const {
  if (t == goals.placed_at) return;
  goals.placed_at = t;
  const double dt = t - goals.t;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    if (!goals.part_drawn[k]) continue;
    Vec3 away = Vec3::Zero();
    double sum = 0;
    for (const int i : parts_[k].nodes) {
      const double weight = goals.part_pinned[k] ? goals.weight[i] : 1 / (1 / k_[i] + dt * dt / mass_[i]);
      away += weight * (goals.x.col(i) + dt * goals.v.col(i) - goals.fitted.col(i));
      sum += weight;
    }
    for (const int i : parts_[k].nodes) goals.place.col(i) = goals.fitted.col(i) + away / sum;
  }
}

bool UntangleTerm::draws(std::span<const std::unique_ptr<Store>> stores) {
  return std::ranges::any_of(stores, [](const std::unique_ptr<Store>& store) {
    const auto* goals = dynamic_cast<const Goals*>(store.get());
    return goals && std::ranges::count(goals->drawn, true) > 0;
  });
}

template <class F>
void UntangleTerm::for_each_drawn(const Goals& goals, const F& f) const {
  for (std::size_t i = 0; i < goals.drawn.size(); ++i)
    if (goals.drawn[i])
      f(static_cast<Eigen::Index>(i), (static_cast<Eigen::Index>(first_node_) + static_cast<Eigen::Index>(i)) * D_);
}

double UntangleTerm::energy(const Motion& motion, Store& store) const {
  auto& goals = static_cast<Goals&>(store);
  place(motion.t, goals);
  double U = 0;
  for_each_drawn(goals, [&](Eigen::Index i, Eigen::Index at) {
    U += 0.5 * k_[i] * (motion.x.segment(at, D_) - goals.place.col(i).head(D_)).squaredNorm();
  });
  return U;
}

void UntangleTerm::add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const {
  auto& goals = static_cast<Goals&>(store);
  place(motion.t, goals);
  for_each_drawn(goals, [&](Eigen::Index i, Eigen::Index at) {
    f.segment(at, D_) -= k_[i] * (motion.x.segment(at, D_) - goals.place.col(i).head(D_));
  });
}

void UntangleTerm::add_product(const Store& store, double s, const Eigen::VectorXd& p, Eigen::VectorXd& y) const {
  for_each_drawn(static_cast<const Goals&>(store),
                 [&](Eigen::Index i, Eigen::Index at) { y.segment(at, D_) += s * k_[i] * p.segment(at, D_); });
}

void UntangleTerm::add_matrix(const Store& store, double s, BlockMatrix& A) const {
  for_each_drawn(static_cast<const Goals&>(store), [&](Eigen::Index i, Eigen::Index) {
    for (int c = 0; c < D_; ++c) A.block(slot_[i])[c * D_ + c] += s * k_[i];
  });
}

void UntangleTerm::add_diagonal(const Store& store, double s, Eigen::VectorXd& d) const {
  for_each_drawn(static_cast<const Goals&>(store),
                 [&](Eigen::Index i, Eigen::Index at) { d.segment(at, D_).array() += s * k_[i]; });
}

void UntangleTerm::bind(const BlockPattern& pattern) {
  for (int i = 0; i < k_.size(); ++i) slot_.push_back(pattern.slot(first_node_ + i, first_node_ + i));
}

}  // namespace sim
