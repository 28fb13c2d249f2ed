// Order in space: a manufactured solution of linear elasticity on irregular meshes, refined.
//   u = a sin(k . X) solves -div sigma = b with b = (mu |k|^2 a + (lambda + mu)(a . k) k) sin(k . X)
#include <Eigen/SparseCholesky>

#include "sim/build/parts.h"
#include "sim/linear/sparse.h"
#include "sim/material/lame.h"
#include "sim/mesh/boundary.h"
#include "sim/mesh/geometry.h"
#include "sim/solve/tangent_operator.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

struct Manufactured {
  int D;
  Vec3 a, k, b;

  explicit Manufactured(int D_) : D(D_), a(0.7, -0.4, D_ == 3 ? 0.5 : 0), k(1.3, 0.9, D_ == 3 ? -1.1 : 0) {
    const Lame l = lame(1e5, 0.3, false);
    b = l.mu * k.squaredNorm() * a + (l.lambda + l.mu) * a.dot(k) * k;
  }
  Vec3 u(const Vec3& X) const { return a * std::sin(k.dot(X)); }
  Vec3 load(const Vec3& X) const { return b * std::sin(k.dot(X)); }
};

// Calls f(element nodes, N, X, w) at every quadrature point of a rule that is exact for N_i N_j.
template <class F>
void for_each_point(const Mesh& mesh, const F& f) {
  visit_mesh(mesh, [&]<class E, int D>(std::type_identity<E>, std::integral_constant<int, D>) {
    for (int e = 0; e < mesh.element_count(); ++e) {
      const auto X_e = gather<E, D>(mesh.X, mesh.elements.col(e).data());
      for (const auto& q : E::mass_rule) {
        Vec3 X = Vec3::Zero();
        X.head(D) = position<E, D>(X_e, q.xi);
        const auto N = E::N(q.xi);
        f(mesh.elements.col(e), N, X, q.weight * std::abs(measure_ratio(jacobian<E, D>(X_e, q.xi))));
      }
    }
  });
}

// Root mean square error of the finite element solution.
double error(const test::Kind& kind, int cells) {
  const Scene scene = test::free_body(kind, "linear", cells);
  System system(scene);
  const Model& parts = parts_of(system).model;
  const Mesh& mesh = *system.bodies()[0].mesh;
  const int D = parts.D;
  const Manufactured exact(D);

  TangentOperator tangent(parts, 1);
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(parts.dofs());
  Eigen::VectorXd f(parts.dofs());
  tangent.begin_step({parts.X, still, 0, 0});
  tangent.linearise({parts.X, still, 0, 0}, 0, Definiteness::none, f);
  BlockMatrix K(*parts.pattern, D);
  tangent.assemble(K);

  Eigen::VectorXd b = still, u = still, free = Eigen::VectorXd::Ones(parts.dofs()), Ku(parts.dofs());
  for_each_point(mesh, [&](const auto& nodes, const auto& N, const Vec3& X, double w) {
    for (int i = 0; i < nodes.size(); ++i) b.segment(nodes[i] * D, D) += w * N[i] * exact.load(X).head(D);
  });
  const Eigen::MatrixXi facets = boundary_facets(mesh);
  for (Eigen::Index i = 0; i < facets.size(); ++i) {
    const int node = facets.data()[i];
    Vec3 X = Vec3::Zero();
    X.head(D) = mesh.X.col(node);
    u.segment(node * D, D) = exact.u(X).head(D);
    free.segment(node * D, D).setZero();
  }
  K.multiply(u, Ku, 1);
  std::vector<Eigen::Index> dof;
  for (Eigen::Index i = 0; i < free.size(); ++i)
    if (free[i] != 0) dof.push_back(i);
  Eigen::VectorXd rhs(dof.size());
  for (std::size_t i = 0; i < dof.size(); ++i) rhs[i] = b[dof[i]] - Ku[dof[i]];
  const Eigen::SimplicialLDLT<SparseMatrix> solver(free_part(K, free));
  const Eigen::VectorXd inner = solver.solve(rhs);
  for (std::size_t i = 0; i < dof.size(); ++i) u[dof[i]] = inner[i];

  double sum = 0, volume = 0;
  for_each_point(mesh, [&](const auto& nodes, const auto& N, const Vec3& X, double w) {
    Vec3 u_h = Vec3::Zero();
    for (int i = 0; i < nodes.size(); ++i) u_h.head(D) += N[i] * u.segment(nodes[i] * D, D);
    sum += w * (u_h - exact.u(X)).squaredNorm();
    volume += w;
  });
  return std::sqrt(sum / volume);
}

TEST(Convergence, TwoForLinearElementsThreeForQuadraticOnes) {
  for (const test::Kind& kind : test::kinds) {
    if (kind.membrane) continue;
    const ElementInfo& element = *find_element(kind.element);
    const int n = element.dimension == 3 ? (element.order == 2 ? 3 : 5) : 8;
    const double order = std::log2(error(kind, n) / error(kind, 2 * n));
    EXPECT_NEAR(order, element.order + 1, 0.15) << kind.element;
  }
}

}  // namespace
}  // namespace sim
