#include "sim/study/pure_newton.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "sim/build/parts.h"
#include "sim/solve/tangent_operator.h"

namespace sim {

namespace {

using Spectrum = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;

// U, its slope and its K in the free components.
class Landscape {
 public:
  explicit Landscape(const System& system)
      : model_(parts_of(system).model), tangent_(model_, 1), still_(Eigen::VectorXd::Zero(model_.dofs())) {
    model_.pins.mark(0, tangent_.free());
    tangent_.begin_step({model_.X, still_, 0, 0});
  }

  double energy(const Eigen::VectorXd& x) { return tangent_.energy({x, still_, 0, 0}); }

  struct Local {
    Eigen::VectorXd force;  // -dU/dx
    Eigen::MatrixXd K;
  };
  Local at(const Eigen::VectorXd& x, Definiteness fix) {
    Eigen::VectorXd f(model_.dofs());
    tangent_.linearise({x, still_, 0, 0}, 0, fix, f);
    return {free_of(f), stiffness()};
  }

  Eigen::VectorXd free_of(const Eigen::VectorXd& whole) const {
    Eigen::VectorXd part(static_cast<Eigen::Index>(tangent_.free().sum()));
    for (Eigen::Index i = 0, k = 0; i < whole.size(); ++i)
      if (tangent_.free()[i] != 0) part[k++] = whole[i];
    return part;
  }
  Eigen::VectorXd moved(Eigen::VectorXd x, const Eigen::VectorXd& dx) const {
    for (Eigen::Index i = 0, k = 0; i < x.size(); ++i)
      if (tangent_.free()[i] != 0) x[i] += dx[k++];
    return x;
  }
  double size() const { return model_.node_size.minCoeff(); }
  // Energies are known to this [J].
  double noise() const { return 1e-15 * model_.energy_scale; }

 private:
  // Column by column, so that the system need not form a matrix.
  Eigen::MatrixXd stiffness() const {
    const auto count = static_cast<Eigen::Index>(tangent_.free().sum());
    Eigen::MatrixXd K(count, count);
    Eigen::VectorXd column(model_.dofs());
    for (Eigen::Index j = 0; j < count; ++j) {
      tangent_.multiply(moved(still_, Eigen::VectorXd::Unit(count, j)), column);
      K.col(j) = free_of(column);
    }
    return K;
  }

  const Model& model_;
  TangentOperator tangent_;
  Eigen::VectorXd still_;
};

constexpr int most = 50, most_halvings = 50;

// How much of the step lowers U as much as the slope promises; 0 where nothing does.
double armijo_share(Landscape& U, const Eigen::VectorXd& x, const Eigen::VectorXd& dx, double slope) {
  const double before = U.energy(x);
  double share = 1;
  for (int k = 0; k < most_halvings; ++k, share /= 2)
    if (U.energy(U.moved(x, share * dx)) <= before + 1e-4 * share * slope + U.noise()) return share;
  return 0;
}

Stationary kind_of(const Eigen::VectorXd& eigenvalues) {
  if (eigenvalues.minCoeff() > 0) return Stationary::minimum;
  return eigenvalues.maxCoeff() < 0 ? Stationary::maximum : Stationary::saddle;
}

}  // namespace

NewtonPath pure_newton(const System& system, const Eigen::VectorXd& start, Definiteness fix) {
  constexpr double tolerance = 1e-9;  // of the body's size
  Landscape U(system);
  NewtonPath path;
  Eigen::VectorXd x = start;
  path.points.push_back(x);
  path.energy.push_back(U.energy(x));
  bool converged = false;
  while (!converged && path.iterations() < most) {
    const Landscape::Local local = U.at(x, fix);
    const Spectrum K(local.K);
    const double largest = K.eigenvalues().cwiseAbs().maxCoeff();
    if (K.eigenvalues().cwiseAbs().minCoeff() <= 1e-12 * largest || largest == 0) {
      path.singular = true;
      break;
    }
    const Eigen::VectorXd dx =
        K.eigenvectors() * (K.eigenvectors().transpose() * local.force).cwiseQuotient(K.eigenvalues());
    const double share = fix == Definiteness::none ? 1 : armijo_share(U, x, dx, -local.force.dot(dx));
    x = U.moved(x, share * dx);
    path.shares.push_back(share);
    path.points.push_back(x);
    path.energy.push_back(U.energy(x));
    converged = dx.cwiseAbs().maxCoeff() <= tolerance * U.size();
  }
  path.end_eigenvalues = Spectrum(U.at(x, Definiteness::none).K).eigenvalues();
  if (converged) path.end = kind_of(path.end_eigenvalues);
  return path;
}

double potential_energy(const System& system, const Eigen::VectorXd& x) {
  return Landscape(system).energy(x);
}

Eigen::MatrixXd made_definite(const Eigen::MatrixXd& K, Definiteness fix) {
  const Spectrum solver(K);
  Eigen::VectorXd values = solver.eigenvalues();
  for (double& value : values) value = sim::made_definite<double>(value, fix);
  return solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace sim
