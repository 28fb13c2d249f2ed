#include "sim/term/traction.h"

#include <sstream>

#include "sim/element/list.h"
#include "sim/mesh/geometry.h"
#include "sim/term/ramp.h"

namespace sim {

TractionLoad::TractionLoad(const Body& body, const Traction& traction, const Eigen::MatrixXi& facets, int first_node,
                           const Eigen::VectorXd& X, int D)
    : body_(body.name), traction_(traction), load_(Eigen::VectorXd::Zero(X.size())), X_(X) {
  visit_mesh(body.mesh, [&]<class Element, int Dim>(std::type_identity<Element>, std::integral_constant<int, Dim>) {
    if (facets.rows() == Element::nodes)  // of a membrane
      add_load<Element, Dim>(body, facets, 1.0, first_node, D);
    else
      add_load<typename Element::Facet, Dim>(body, facets, Element::dimension == 2 ? body.thickness : 1.0, first_node,
                                             D);
  });
}

template <class Facet, int Dim>
void TractionLoad::add_load(const Body& body, const Eigen::MatrixXi& facets, double thickness, int first_node, int D) {
  for (Eigen::Index k = 0; k < facets.cols(); ++k) {
    const auto X_f = gather<Facet, Dim>(body.mesh.X, facets.col(k).data());
    for (const auto& q : Facet::rule) {
      const auto N = Facet::N(q.xi);
      const double dA = q.weight * thickness * measure_ratio(jacobian<Facet>(X_f, q.xi));
      area_ += dA;
      for (int a = 0; a < Facet::nodes; ++a)
        load_.segment(static_cast<Eigen::Index>(first_node + facets(a, k)) * D, D) +=
            N[a] * dA * traction_.value.head(D);
    }
  }
}

TermInfo TractionLoad::info() const {
  std::ostringstream what;
  what << "(" << traction_.value.x() << ", " << traction_.value.y() << ", " << traction_.value.z() << ") Pa on "
       << area_ << " m^2";
  return {"traction " + body_, what.str()};
}

double TractionLoad::energy(const Motion& motion, Store&) const {
  return -risen(motion.t, traction_.ramp) * load_.dot(motion.x - X_);
}

void TractionLoad::add_forces(const Motion& motion, Store&, Eigen::VectorXd& f) const {
  f += risen(motion.t, traction_.ramp) * load_;
}

}  // namespace sim
