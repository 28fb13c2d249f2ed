#include "sim/build/bending.h"

#include <Eigen/Cholesky>
#include <numeric>
#include <vector>

#include "sim/element/element.h"
#include "sim/mesh/generate.h"
#include "sim/term/elastic.h"

namespace sim {
namespace {

// What pure bending with curvature 1 does to a point: plane sections turn, and the section changes its shape as it must
// where it is compressed and stretched.
Eigen::VectorXd bent(const Eigen::VectorXd& X, const Vec3& lengths, double poisson) {
  const double x = X[0], y = X[1] - lengths[1] / 2;
  if (X.size() == 2) return Eigen::Vector2d(-x * y, (x * x + poisson / (1 - poisson) * y * y) / 2);
  const double z = X[2] - lengths[2] / 2;
  return Vec3(-x * y, (x * x + poisson * (y * y - z * z)) / 2, poisson * y * z);
}

// The components that stay free, and what the others are moved by. Of a confined block all of the surface is moved;
// else the end faces along the block, and a corner and the one above it as far as nothing may move as a whole.
struct Grip {
  std::vector<int> free;
  Eigen::VectorXd u;
};

Grip grip_of(const Mesh& mesh, const BentBlock& block, double poisson) {
  const auto D = static_cast<int>(mesh.X.rows());
  const Vec3& L = block.lengths;
  const double nearly = 1e-9 * L.minCoeff();
  Grip grip;
  grip.u = Eigen::VectorXd::Zero(mesh.X.size());
  for (int i = 0; i < mesh.node_count(); ++i) {
    const Eigen::VectorXd X = mesh.X.col(i), there = bent(X, L, poisson);
    const auto ends = [&](int axis) { return X[axis] < nearly || X[axis] > L[axis] - nearly; };
    const bool outside = ends(0) || ends(1) || (D == 3 && ends(2));
    const bool foot = X.norm() < nearly, above = (X - L[1] * Eigen::VectorXd::Unit(D, 1)).norm() < nearly;
    for (int c = 0; c < D; ++c) {
      const bool held = block.confined ? outside : c == 0 ? ends(0) : foot || (c == 2 && above);
      if (held)
        grip.u[i * D + c] = there[c];
      else
        grip.free.push_back(i * D + c);
    }
  }
  return grip;
}

// K of the body at rest, column by column: the block is small.
Eigen::MatrixXd stiffness(const Body& body) {
  const auto D = static_cast<int>(body.mesh.X.rows());
  std::vector<int> all(static_cast<std::size_t>(body.mesh.element_count()));
  std::iota(all.begin(), all.end(), 0);
  const auto term = make_elastic({body, body.materials[0], all, 0, body.mesh.node_count()}, D);
  const Eigen::VectorXd X = body.mesh.X.reshaped(), v = Eigen::VectorXd::Zero(X.size());
  Eigen::VectorXd f = v;
  const auto store = term->make_store(1);
  term->linearise({X, v, 0, 0}, Definiteness::none, *store, f);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(X.size(), X.size());
  Eigen::VectorXd column(X.size());
  for (Eigen::Index j = 0; j < X.size(); ++j) {
    column.setZero();
    term->add_product(*store, 1, Eigen::VectorXd::Unit(X.size(), j), column);
    K.col(j) = column;
  }
  return K;
}

}  // namespace

double bending_excess(ElementKind kind, const BentBlock& block, double poisson) {
  const bool plane = info(kind).dimension == 2;
  const Vec3& L = block.lengths;
  Body body;
  body.mesh = plane ? generate_rectangle(L.head<2>(), {block.cells[0], block.cells[1]}, {1, 1}, kind)
                    : generate_box(L, block.cells, {1, 1, 1}, kind);
  body.materials = {MaterialSpec{"linear", 1, poisson, 1, ""}};
  const Grip grip = grip_of(body.mesh, block, poisson);
  const Eigen::MatrixXd K = stiffness(body);
  const Eigen::VectorXd pull = -(K * grip.u)(grip.free);
  Eigen::VectorXd u = grip.u;
  const Eigen::MatrixXd K_free = K(grip.free, grip.free);
  u(grip.free) = K_free.llt().solve(pull).eval();
  // Young's modulus and curvature 1: W = L E I/2, I = b H^3/12, under plane strain over 1 - nu^2 and for b = 1.
  const double width = plane ? 1 / (1 - poisson * poisson) : L[2];
  const double exact = L[0] * width * L[1] * L[1] * L[1] / 24;
  return 0.5 * u.dot(K * u) / exact - 1;
}

}  // namespace sim
