#include "sim/body/mass.h"

#include "sim/element/list.h"
#include "sim/mesh/geometry.h"

namespace sim {

namespace {

// m_ij = sum_q w rho N_i N_j over one element.
template <class Element, int D>
Eigen::Matrix<double, Element::nodes, Element::nodes> element_mass(const Mesh& mesh, int e, double rho,
                                                                   double thickness) {
  const auto X_e = gather<Element, D>(mesh.X, mesh.elements.col(e).data());
  Eigen::Matrix<double, Element::nodes, Element::nodes> m;
  m.setZero();
  for (const auto& q : Element::mass_rule) {
    const auto N_array = Element::N(q.xi);
    const Eigen::Map<const Eigen::Matrix<double, Element::nodes, 1>> N(N_array.data());
    const double measure = std::abs(measure_ratio(jacobian<Element>(X_e, q.xi)));
    m += (q.weight * measure * (Element::dimension == 3 ? 1 : thickness) * rho) * N * N.transpose();
  }
  return m;
}

// Lumped: row sums on linear elements; on quadratic ones the diagonal, scaled to the element's mass [HRZ: Hinton,
// Rock, Zienkiewicz 1976], as row sums vanish or turn negative there.
template <class Element>
Eigen::Matrix<double, Element::nodes, 1> lump(const Eigen::Matrix<double, Element::nodes, Element::nodes>& m) {
  if constexpr (Element::order == 1) return m.rowwise().sum();
  return m.diagonal() * (m.sum() / m.diagonal().sum());
}

template <class F>
void for_each_element_mass(const Body& body, const std::vector<double>& density, const F& f) {
  visit_mesh(body.mesh, [&]<class Element, int D>(std::type_identity<Element>, std::integral_constant<int, D>) {
    for (int e = 0; e < body.mesh.element_count(); ++e)
      f(body.mesh.elements.col(e), element_mass<Element, D>(body.mesh, e, density[e], body.thickness),
        [](const auto& m) { return lump<Element>(m); });
  });
}

}  // namespace

Mass::Mass(const Body& body, const std::vector<double>& density, int first_node)
    : first_node_(first_node), nodal_(Eigen::VectorXd::Zero(body.mesh.node_count())) {
  if (body.mass == MassMatrix::consistent) {
    Coupling coupling(body.mesh.node_count());
    for (int e = 0; e < body.mesh.element_count(); ++e)
      coupling.add({body.mesh.elements.col(e).data(), static_cast<std::size_t>(body.mesh.elements.rows())});
    consistent_.emplace();
    consistent_->pattern = coupling.pattern();
    consistent_->values.assign(consistent_->pattern.column.size(), 0.0);
  }
  for_each_element_mass(body, density, [&](const auto& nodes, const auto& m, const auto& lumped) {
    const Eigen::VectorXd shares = consistent_ ? Eigen::VectorXd(m.rowwise().sum()) : Eigen::VectorXd(lumped(m));
    for (int a = 0; a < nodes.size(); ++a) {
      nodal_[nodes[a]] += shares[a];
      if (!consistent_) continue;
      for (int b = 0; b < nodes.size(); ++b)
        consistent_->values[consistent_->pattern.slot(nodes[a], nodes[b])] += m(a, b);
    }
  });
  total_ = nodal_.sum();
}

Mass Mass::unit(int first, int count) {
  return {first, Eigen::VectorXd::Ones(count)};
}

void Mass::add_product(double s, const Eigen::VectorXd& p, Eigen::VectorXd& y, int D) const {
  for (int i = 0; i < nodal_.size(); ++i) {
    const Eigen::Index at = static_cast<Eigen::Index>(first_node_ + i) * D;
    if (!consistent_) {
      for (int c = 0; c < D; ++c) y[at + c] += s * nodal_[i] * p[at + c];
      continue;
    }
    for (int k = consistent_->pattern.start[i]; k < consistent_->pattern.start[i + 1]; ++k) {
      const Eigen::Index other = static_cast<Eigen::Index>(first_node_ + consistent_->pattern.column[k]) * D;
      for (int c = 0; c < D; ++c) y[at + c] += s * consistent_->values[k] * p[other + c];
    }
  }
}

void Mass::add_diagonal(double s, Eigen::VectorXd& d, int D) const {
  for (int i = 0; i < nodal_.size(); ++i) {
    const double m = consistent_ ? consistent_->values[consistent_->pattern.slot(i, i)] : nodal_[i];
    for (int c = 0; c < D; ++c) d[static_cast<Eigen::Index>(first_node_ + i) * D + c] += s * m;
  }
}

void Mass::add_matrix(double s, BlockMatrix& A) const {
  const int D = A.D();
  const auto add = [&](int slot, double m) {
    double* block = A.block(slot);
    for (int c = 0; c < D; ++c) block[c * D + c] += s * m;
  };
  if (consistent_)
    for (std::size_t k = 0; k < consistent_->slot.size(); ++k) add(consistent_->slot[k], consistent_->values[k]);
  else
    for (int i = 0; i < nodal_.size(); ++i) add(diagonal_slot_[i], nodal_[i]);
}

void Mass::couple(Coupling& coupling) const {
  for (int i = 0; i < nodal_.size(); ++i) {
    const int node = first_node_ + i;
    coupling.add({&node, 1});
  }
}

void Mass::bind(const BlockPattern& pattern) {
  if (!consistent_) {
    for (int i = 0; i < nodal_.size(); ++i) diagonal_slot_.push_back(pattern.slot(first_node_ + i, first_node_ + i));
    return;
  }
  for (int i = 0; i < nodal_.size(); ++i)
    for (int k = consistent_->pattern.start[i]; k < consistent_->pattern.start[i + 1]; ++k)
      consistent_->slot.push_back(pattern.slot(first_node_ + i, first_node_ + consistent_->pattern.column[k]));
}

}  // namespace sim
