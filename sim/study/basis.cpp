#include "sim/study/basis.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "sim/build/key_path.h"
#include "sim/build/parts.h"
#include "sim/build/reduction.h"
#include "sim/solve/mass_product.h"
#include "sim/solve/tangent_operator.h"
#include "sim/study/cubature.h"
#include "sim/study/modes.h"
#include "sim/study/pencil.h"

namespace sim {

namespace {

// The modes of which there are enough, with their derivatives: the least k with k + k (k + 1)/2 >= count.
int modes_for(int count) {
  int k = 1;
  while (k + k * (k + 1) / 2 < count) ++k;
  return k;
}

// A body alone, and its K and M.
class Rest {
 public:
  Rest(const Scene& scene, std::size_t body)
      : system_(at_rest_alone(scene, body)), pencil_(system_), model_(parts_of(system_).model) {}

  const System& system() const { return system_; }
  const Pencil& pencil() const { return pencil_; }
  const Model& model() const { return model_; }

  // Rigid motions that no pin resists: how many.
  Eigen::Index rigid_motions() const {
    const int D = model_.D, turns = D == 2 ? 1 : 3;
    Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(model_.dofs(), D + turns);
    const double size = model_.ranges[0].size;
    for (Eigen::Index i = 0; i < model_.dofs(); ++i) {
      if (pencil_.free[i] != 0) continue;
      const Eigen::Index node = i / D, axis = i % D;
      rigid(i, axis) = 1;
      for (int t = 0; t < turns; ++t) {
        Vec3 X = Vec3::Zero();
        X.head(D) = model_.X.segment(node * D, D) - model_.X.head(D);
        rigid(i, D + t) = Vec3::Unit(D == 2 ? 2 : t).cross(X / size)[axis];
      }
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(rigid);
    qr.setThreshold(1e-8);
    return D + turns - qr.rank();
  }

 private:
  System system_;
  Pencil pencil_;
  const Model& model_;
};

// The vectors in their order, each without what those before it have of it in the mass norm; those of which nothing is
// left are dropped. At most `count`.
Eigen::MatrixXd orthonormal(const Model& model, const Eigen::MatrixXd& vectors, int count) {
  constexpr double nothing = 1e-8;
  Eigen::MatrixXd U(vectors.rows(), 0), MU(vectors.rows(), 0);
  for (Eigen::Index k = 0; k < vectors.cols() && U.cols() < count; ++k) {
    Eigen::VectorXd u = vectors.col(k);
    const double before = std::sqrt(u.dot(mass_product(model, u)));
    for (int pass = 0; pass < 2; ++pass)  // once more, for round-off
      for (Eigen::Index j = 0; j < U.cols(); ++j) u -= MU.col(j).dot(u) * U.col(j);
    const double left = std::sqrt(u.dot(mass_product(model, u)));
    if (!(left > nothing * before)) continue;
    u /= left;
    U.conservativeResize(Eigen::NoChange, U.cols() + 1);
    MU.conservativeResize(Eigen::NoChange, U.cols());
    U.rightCols(1) = u;
    MU.rightCols(1) = mass_product(model, u);
  }
  return U;
}

Eigen::MatrixXd beside(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd both(a.rows(), a.cols() + b.cols());
  both << a, b;
  return both;
}

// (K(X + e psi_i) - K(X - e psi_i))/(2 e) psi_j for all j, with e psi_i a small share of the body's size.
class StiffnessChange {
 public:
  explicit StiffnessChange(const Rest& rest) : rest_(rest), tangent_(rest.model(), 1) {
    tangent_.free() = rest.pencil().free;
  }
  Eigen::MatrixXd along(const Eigen::VectorXd& psi, const Eigen::MatrixXd& at) {
    constexpr double share = 1e-5;
    const Model& model = rest_.model();
    const double e = share * model.ranges[0].size / psi.cwiseAbs().maxCoeff();
    return (product(model.X + e * psi, at) - product(model.X - e * psi, at)) / (2 * e);
  }

 private:
  Eigen::MatrixXd product(const Eigen::VectorXd& x, const Eigen::MatrixXd& at) {
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(x.size());
    Eigen::VectorXd f(x.size()), p, Kp(x.size());
    Eigen::MatrixXd all(at.rows(), at.cols());
    tangent_.begin_step({x, still, 0, 0});
    tangent_.linearise({x, still, 0, 0}, 0, Definiteness::none, f);
    for (Eigen::Index j = 0; j < at.cols(); ++j) {
      p = at.col(j);
      tangent_.multiply(p, Kp);
      all.col(j) = Kp;
    }
    return all;
  }
  const Rest& rest_;
  TangentOperator tangent_;
};

Eigen::MatrixXd derivatives_of(const Rest& rest, const Eigen::MatrixXd& psi) {
  const Pencil& pencil = rest.pencil();
  PencilFactor factor(rest.system(), 0);
  const Eigen::Index k = psi.cols();
  Eigen::MatrixXd Phi = Eigen::MatrixXd::Zero(psi.rows(), k * (k + 1) / 2);
  StiffnessChange change(rest);
  for (Eigen::Index i = 0, pair = 0; i < k; ++i) {
    const Eigen::MatrixXd dK = change.along(psi.col(i), psi.rightCols(k - i));
    for (Eigen::Index j = i; j < k; ++j, ++pair) {
      Eigen::VectorXd b(pencil.size());
      for (Eigen::Index n = 0, row = 0; n < psi.rows(); ++n)
        if (pencil.free[n] != 0) b[row++] = -dK(n, j - i);
      Eigen::VectorXd x(pencil.size());
      factor.solve(b.data(), x.data());
      for (Eigen::Index n = 0, row = 0; n < psi.rows(); ++n)
        if (pencil.free[n] != 0) Phi(n, pair) = x[row++];
    }
  }
  return Phi;
}

// The left singular vectors of M^1/2 S by the eigenvectors of S^T M S: U = S V / sigma, the largest sigma first.
Eigen::MatrixXd principal(const Rest& rest, const Eigen::MatrixXd& snapshots) {
  Eigen::MatrixXd S = snapshots;
  S.array().colwise() *= rest.pencil().free.array();
  Eigen::MatrixXd MS(S.rows(), S.cols());
  for (Eigen::Index k = 0; k < S.cols(); ++k) MS.col(k) = mass_product(rest.model(), S.col(k));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(S.transpose().lazyProduct(MS));
  return S.lazyProduct(eigen.eigenvectors().rowwise().reverse());
}

Eigen::MatrixXd vectors_of(const Scene& scene, std::size_t b, const Rest& rest, int& modes) {
  const Basis& basis = *scene.bodies[b].basis;
  if (basis.kind == BasisKind::snapshots) {
    if (!basis.snapshots || basis.snapshots->rows() != rest.model().dofs())
      throw InputError("basis.from", "is missing: the run folder whose states make the basis");
    return principal(rest, *basis.snapshots);
  }
  modes = basis.kind == BasisKind::modes ? basis.count : modes_for(basis.count);
  const Eigen::MatrixXd psi = vibration_modes(scene, b, modes).shape;
  modes = static_cast<int>(psi.cols());
  return basis.kind == BasisKind::modes ? psi : beside(psi, derivatives_of(rest, psi));
}

BasisVectors make_vectors(const Scene& scene, std::size_t b) {
  const Body& body = scene.bodies[b];
  const std::string key = key_of("body", b) + ".basis";
  const Rest rest(scene, b);
  if (const Eigen::Index motions = rest.rigid_motions(); motions > 0)
    throw InputError(key, "nothing holds \"" + body.name + "\" (" + std::to_string(motions) +
                              " rigid motions are left), and x = X + U c cannot follow a body that turns; pin it, or "
                              "leave out the basis");
  BasisVectors made;
  const Eigen::MatrixXd vectors = below(key_of("body", b), [&] { return vectors_of(scene, b, rest, made.modes); });
  made.U = orthonormal(rest.model(), vectors, body.basis->count);
  if (made.U.cols() < body.basis->count)
    throw InputError(key + ".count",
                     "there are only " + std::to_string(made.U.cols()) + " independent vectors of this kind");
  return made;
}

}  // namespace

bool has_basis(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) { return body.basis.has_value(); });
}

Eigen::MatrixXd modal_derivatives(const Scene& scene, std::size_t body, const Eigen::MatrixXd& psi) {
  return derivatives_of(Rest(scene, body), psi);
}

Scene with_bases_made(Scene scene, int threads) {
  if (!has_basis(scene)) return scene;
  check_bases(scene);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    Basis& basis = *scene.bodies[b].basis;
    if (!basis.vectors) basis.vectors = std::make_shared<const BasisVectors>(make_vectors(scene, b));
  }
  train_cubatures(scene, threads);
  return scene;
}

}  // namespace sim
