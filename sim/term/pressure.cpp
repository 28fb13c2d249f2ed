#include "sim/term/pressure.h"

#include <array>
#include <map>
#include <sstream>
#include <utility>

#include "sim/element/element.h"
#include "sim/mesh/components.h"
#include "sim/mesh/input_error.h"
#include "sim/term/enclosed.h"
#include "sim/term/ramp.h"

namespace sim {

// The positions and the strength of the last linearisation: 0 where the tangent shall be definite, as this one's
// eigenvalues are pairs of both signs. rim is the force of a unit strength that has no potential; none without a rim.
struct PressureLoad::Kept final : Store {
  Eigen::VectorXd x, start, rim;
  double strength = 0;
};

namespace {

// The corners of a facet in order, by its number of nodes: three nodes are a triangle in space, an edge in the plane.
int corners_of(Eigen::Index nodes, int D) {
  return D == 2 ? 2 : nodes == 4 ? 4 : 3;
}

}  // namespace

// Calls f.operator()<Facet, D>(k) for every facet.
template <class F>
void PressureLoad::visit(const F& f) const {
  const auto all = [&]<class Facet, int D>() {
    for (Eigen::Index k = 0; k < facets_.cols(); ++k) f.template operator()<Facet, D>(k);
  };
  if (D_ == 2) {
    facets_.rows() == 2 ? all.template operator()<Edge2, 2>() : all.template operator()<Edge3, 2>();
  } else if (facets_.rows() == 4) {
    all.template operator()<Quad4, 3>();
  } else {
    facets_.rows() == 3 ? all.template operator()<Tri3, 3>() : all.template operator()<Tri6, 3>();
  }
}

template <class Facet, int D>
Eigen::Matrix<double, D, Facet::nodes> PressureLoad::gathered(const Eigen::VectorXd& x, Eigen::Index facet) const {
  Eigen::Matrix<double, D, Facet::nodes> x_f;
  for (int a = 0; a < Facet::nodes; ++a)
    x_f.col(a) = x.segment<D>(static_cast<Eigen::Index>(facets_(a, facet)) * D) - origin_.head<D>();
  return x_f;
}

PressureLoad::PressureLoad(const Body& body, const Pressure& pressure, const Eigen::MatrixXi& facets, int first_node,
                           const Eigen::VectorXd& X, int D)
    : body_(body.name), pressure_(pressure), facets_(facets.array() + first_node), D_(D) {
  if (D == 2) thickness_ = body.thickness;
  origin_.head(D) = X.segment(static_cast<Eigen::Index>(facets_(0, 0)) * D, D);
  orient(body, X);
  visit([&]<class Facet, int Dim>(Eigen::Index k) {
    area_ += thickness_ * Enclosed<Facet, Dim>::pressed(gathered<Facet, Dim>(X, k)).rowwise().sum().norm();
  });
  rest_volume_ = volume(X);
}

// A solid's facets face outwards, and pressure acts against them. A membrane's face as its elements do; each part of it
// that encloses a volume is turned to face outwards, so that pressure acts from inside.
void PressureLoad::orient(const Body& body, const Eigen::VectorXd& X) {
  const int corners = corners_of(facets_.rows(), D_);
  std::map<std::array<int, 2>, int> sides;  // from corner to corner; a corner alone in the plane
  const auto side_of = [&](const auto& facet, int i) {
    return std::array{facet[i], D_ == 3 ? facet[(i + 1) % corners] : -1 - i};
  };
  const auto other = [&](const std::array<int, 2>& side) {
    return D_ == 3 ? std::array{side[1], side[0]} : std::array{side[0], -3 - side[1]};
  };
  bool alike = true;
  for (const auto& facet : facets_.colwise())
    for (int i = 0; i < corners; ++i) alike = ++sides[side_of(facet, i)] == 1 && alike;
  std::vector<char> at_rim(static_cast<std::size_t>(facets_.cols()), 0);
  for (std::size_t k = 0; k < at_rim.size(); ++k)
    for (int i = 0; i < corners; ++i)
      if (!sides.contains(other(side_of(facets_.col(static_cast<Eigen::Index>(k)), i)))) at_rim[k] = open_ = true;
  if (sim::info(body.mesh.kind).dimension == D_) return;
  sign_ = 1;
  if (!alike) throw InputError("value", "the faces of \"" + body.name + "\" do not all face the same way");
  turn_outwards(body.mesh.kind, at_rim, X);
}

void PressureLoad::turn_outwards(ElementKind kind, const std::vector<char>& at_rim, const Eigen::VectorXd& X) {
  std::vector<double> enclosed(at_rim.size());
  visit([&]<class Facet, int D>(Eigen::Index k) {
    enclosed[static_cast<std::size_t>(k)] = Enclosed<Facet, D>::volume(gathered<Facet, D>(X, k));
  });
  Mesh surface;
  surface.kind = kind;
  surface.X.resize(D_, X.size() / D_);
  surface.elements = facets_;
  for (const Component& part : components(surface)) {
    double V = 0;
    bool closed = true;
    for (const int k : part.elements) {
      V += enclosed[static_cast<std::size_t>(k)];
      closed = closed && !at_rim[static_cast<std::size_t>(k)];
    }
    if (!closed || V > 0) continue;
    for (const int k : part.elements) {
      auto facet = facets_.col(k);
      std::swap(facet[1], facet[2]);
      if (facet.size() == 6) std::swap(facet[3], facet[5]);
    }
  }
}

TermInfo PressureLoad::info() const {
  std::ostringstream what;
  what << pressure_.value << " Pa on " << area_ << " m^2 at rest, " << (open_ ? "open" : "closed");
  return {"pressure " + body_, what.str()};
}

double PressureLoad::strength(double t) const {
  return sign_ * risen(t, pressure_.ramp) * pressure_.value * thickness_;
}

std::unique_ptr<Term::Store> PressureLoad::make_store(int threads) const {
  auto store = std::make_unique<Kept>();
  store->threads = threads;
  return store;
}

double PressureLoad::volume(const Eigen::VectorXd& x) const {
  double V = 0;
  visit([&]<class Facet, int D>(Eigen::Index k) { V += Enclosed<Facet, D>::volume(gathered<Facet, D>(x, k)); });
  return V;
}

// At nodes of the rim: int N n dA - dV/dx of the facets there.
void PressureLoad::begin_step(const Motion& start, Store& store) const {
  if (!open_) return;
  Kept& kept = static_cast<Kept&>(store);
  kept.start = start.x;
  kept.rim.setZero(start.x.size());
  visit([&]<class Facet, int D>(Eigen::Index k) {
    const auto x = gathered<Facet, D>(start.x, k);
    const auto difference = (Enclosed<Facet, D>::pressed(x) - Enclosed<Facet, D>::gradient(x)).eval();
    for (int a = 0; a < Facet::nodes; ++a)
      kept.rim.template segment<D>(static_cast<Eigen::Index>(facets_(a, k)) * D) += difference.col(a);
  });
}

double PressureLoad::energy(const Motion& motion, Store& store) const {
  const Kept& kept = static_cast<const Kept&>(store);
  const double along = kept.rim.size() > 0 ? kept.rim.dot(motion.x - kept.start) : 0;
  return -strength(motion.t) * (volume(motion.x) - rest_volume_ + along);
}

void PressureLoad::add_forces(const Motion& motion, Store& store, Eigen::VectorXd& f) const {
  const Kept& kept = static_cast<const Kept&>(store);
  const double p = strength(motion.t);
  visit([&]<class Facet, int D>(Eigen::Index k) {
    const auto g = Enclosed<Facet, D>::gradient(gathered<Facet, D>(motion.x, k));
    for (int a = 0; a < Facet::nodes; ++a)
      f.template segment<D>(static_cast<Eigen::Index>(facets_(a, k)) * D) += p * g.col(a);
  });
  if (kept.rim.size() > 0) f += p * kept.rim;
}

void PressureLoad::linearise(const Motion& motion, Definiteness fix, Store& store, Eigen::VectorXd& f) const {
  Kept& kept = static_cast<Kept&>(store);
  kept.x = motion.x;
  kept.strength = fix == Definiteness::none ? strength(motion.t) : 0;
  add_forces(motion, store, f);
}

// K = -p d2V/dx2
void PressureLoad::add_product(const Store& store, double s, const Eigen::VectorXd& p, Eigen::VectorXd& y) const {
  const Kept& kept = static_cast<const Kept&>(store);
  if (kept.strength == 0) return;
  visit([&]<class Facet, int D>(Eigen::Index k) {
    const auto x = gathered<Facet, D>(kept.x, k);
    for (int a = 0; a < Facet::nodes; ++a)
      for (int b = 0; b < Facet::nodes; ++b)
        y.template segment<D>(static_cast<Eigen::Index>(facets_(a, k)) * D) -=
            s * kept.strength * Enclosed<Facet, D>::hessian(x, a, b) *
            p.template segment<D>(static_cast<Eigen::Index>(facets_(b, k)) * D);
  });
}

void PressureLoad::add_matrix(const Store& store, double s, BlockMatrix& A) const {
  const Kept& kept = static_cast<const Kept&>(store);
  if (kept.strength == 0) return;
  const auto n = static_cast<std::size_t>(facets_.rows());
  visit([&]<class Facet, int D>(Eigen::Index k) {
    const auto x = gathered<Facet, D>(kept.x, k);
    for (int a = 0; a < Facet::nodes; ++a)
      for (int b = 0; b < Facet::nodes; ++b) {
        if (facets_(a, k) > facets_(b, k)) continue;
        Eigen::Map<Eigen::Matrix<double, D, D, Eigen::RowMajor>> block(A.block(
            slot_[(static_cast<std::size_t>(k) * n + static_cast<std::size_t>(a)) * n + static_cast<std::size_t>(b)]));
        block -= s * kept.strength * Enclosed<Facet, D>::hessian(x, a, b);
      }
  });
}

// Blocks (a, a) are antisymmetric: nothing on the diagonal.
void PressureLoad::add_diagonal(const Store&, double, Eigen::VectorXd&) const {}

void PressureLoad::couple(Coupling& coupling) const {
  for (const auto& facet : facets_.colwise()) coupling.add({facet.data(), static_cast<std::size_t>(facet.size())});
}

void PressureLoad::bind(const BlockPattern& pattern) {
  slot_.clear();
  for (const auto& facet : facets_.colwise())
    for (const int a : facet)
      for (const int b : facet) slot_.push_back(pattern.slot(a, b));
}

}  // namespace sim
