#include "sim/term/untangle.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "sim/math/rigid_fit.h"
#include "sim/mesh/geometry.h"

namespace sim {

namespace {

// sum_e E_e V_e/l_e^2/n_e of the elements at each node [N/m], l_e^dimension the element's measure.
Eigen::VectorXd nodal_stiffness(const Body& body, const std::vector<int>& material) {
  const Mesh& mesh = body.mesh;
  Eigen::VectorXd k = Eigen::VectorXd::Zero(mesh.node_count());
  visit_mesh(mesh, [&]<class E, int D>(std::type_identity<E>, std::integral_constant<int, D>) {
    const double across = E::dimension == 2 ? body.thickness : 1;
    for (int e = 0; e < mesh.element_count(); ++e) {
      const double V = measure<E, D>(gather<E, D>(mesh.X, mesh.elements.col(e).data()), E::rule);
      for (const int node : mesh.elements.col(e))
        k[node] += body.materials[material[e]].young * across * std::pow(V, 1 - 2.0 / E::dimension) / E::nodes;
    }
  });
  return k;
}

}  // namespace

// Of the nodes of the body: whether and where each is drawn.
struct UntangleTerm::Goals : Store {
  double t = 0;  // s, when the step began
  std::vector<bool> drawn;
  Eigen::Matrix3Xd place, drift;  // m, m/s
  // Scratch of begin_step.
  Eigen::VectorXd free;    // of the system, for a look at the pins
  Eigen::Matrix3Xd x, v;   // of the body
  Eigen::VectorXd weight;  // in the fit, N/m
};

UntangleTerm::UntangleTerm(const Body& body, const std::vector<int>& material, int first_node, const Eigen::VectorXd& X,
                           const Pins& pins, int D)
    : body_(body.name),
      strength_(body.untangle),
      first_node_(first_node),
      D_(D),
      dofs_(X.size()),
      X_(Eigen::Matrix3Xd::Zero(3, body.mesh.node_count())),
      k_(strength_ * nodal_stiffness(body, material)),
      pins_(pins) {
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
  store->place = store->drift = store->x = store->v = Eigen::Matrix3Xd::Zero(3, X_.cols());
  store->free.resize(dofs_);
  store->weight.resize(X_.cols());
  return store;
}

void UntangleTerm::take(const Eigen::VectorXd& x, Eigen::Matrix3Xd& p) const {
  p.topRows(D_) = x.segment(static_cast<Eigen::Index>(first_node_) * D_, X_.cols() * D_).reshaped(D_, X_.cols());
}

void UntangleTerm::aim(const Part& part, const Motion& start, Goals& goals) const {
  constexpr double lead = 1e3;  // of a pinned node, times its weight
  pins_.mark(start.t, goals.free);
  goals.weight = k_;
  for (const int i : part.nodes)
    if (goals.free.segment(static_cast<Eigen::Index>(first_node_ + i) * D_, D_).minCoeff() == 0)
      goals.weight[i] *= lead;
  take(start.x, goals.x);
  take(start.v, goals.v);
  const RigidFit fit = fit_rigid(X_, goals.x, goals.weight, part.nodes, D_);
  Vec3 mean = Vec3::Zero();
  double sum = 0;
  for (const int i : part.nodes) {
    mean += goals.weight[i] * goals.v.col(i);
    sum += goals.weight[i];
  }
  for (const int i : part.nodes) {
    goals.drawn[i] = true;
    goals.place.col(i) = fit.place(X_.col(i));
    goals.drift.col(i) = mean / sum;
  }
}

void UntangleTerm::begin_step(const Motion& start, Store& store) const {
  auto& goals = static_cast<Goals&>(store);
  goals.t = start.t;
  goals.drawn.assign(goals.drawn.size(), false);
  for (const Part& part : parts_)
    if (part.tangle.count(start.x).any()) aim(part, start, goals);
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
  const auto& goals = static_cast<const Goals&>(store);
  double U = 0;
  for_each_drawn(goals, [&](Eigen::Index i, Eigen::Index at) {
    const Vec3 g = goals.place.col(i) + (motion.t - goals.t) * goals.drift.col(i);
    U += 0.5 * k_[i] * (motion.x.segment(at, D_) - g.head(D_)).squaredNorm();
  });
  return U;
}

void UntangleTerm::add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const {
  const auto& goals = static_cast<const Goals&>(store);
  for_each_drawn(goals, [&](Eigen::Index i, Eigen::Index at) {
    const Vec3 g = goals.place.col(i) + (motion.t - goals.t) * goals.drift.col(i);
    f.segment(at, D_) -= k_[i] * (motion.x.segment(at, D_) - g.head(D_));
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
