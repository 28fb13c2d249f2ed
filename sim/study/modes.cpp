#include "sim/study/modes.h"

#include <Spectra/MatOp/SparseCholesky.h>
#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsShiftSolver.h>
#include <Spectra/SymGEigsSolver.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <memory>

#include "sim/body/start.h"
#include "sim/study/pencil.h"
#include "sim/system.h"

namespace sim {

namespace {

using Product = Spectra::SparseSymMatProd<double>;

constexpr Eigen::Index few = 200;  // unknowns for which a dense solver is as fast

struct Pairs {
  Eigen::VectorXd values;   // omega^2, rising
  Eigen::MatrixXd vectors;  // of the free components
};

Pairs dense_pairs(const Pencil& pencil, Eigen::Index count) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(Eigen::MatrixXd(pencil.K),
                                                                         Eigen::MatrixXd(pencil.M));
  return {solver.eigenvalues().head(count), solver.eigenvectors().leftCols(count)};
}

// (K - sigma M)^{-1}, as Spectra asks for it.
class ShiftInvert {
 public:
  using Scalar = double;
  ShiftInvert(const System& system, double sigma) : factor_(std::make_unique<PencilFactor>(system, -sigma)) {}
  Eigen::Index rows() const { return factor_->size(); }
  Eigen::Index cols() const { return factor_->size(); }
  void set_shift(double /*sigma*/) {}  // it has it
  void perform_op(const double* b, double* x) const { factor_->solve(b, x); }

 private:
  std::unique_ptr<PencilFactor> factor_;
};

// Shift and invert about a value a little below zero, so that K - sigma M has a factor where K has none.
Pairs sparse_pairs(const System& system, const Pencil& pencil, Eigen::Index count) {
  const double sigma = -1e-9 * pencil.K.diagonal().maxCoeff() / pencil.M.diagonal().maxCoeff();
  ShiftInvert shift(system, sigma);
  Product product(pencil.M);
  const Eigen::Index space = std::min(pencil.size(), 4 * count + 20);
  Spectra::SymGEigsShiftSolver<ShiftInvert, Product, Spectra::GEigsMode::ShiftInvert> solver(shift, product, count,
                                                                                             space, sigma);
  solver.init();
  solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-10, Spectra::SortRule::SmallestAlge);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

// The largest component, and of several that are equal but for round-off the first.
double leading(const Eigen::VectorXd& psi) {
  constexpr double as_large = 1 - 1e-6;
  const double largest = psi.cwiseAbs().maxCoeff();
  return *std::find_if(psi.begin(), psi.end(),
                       [&](double component) { return std::abs(component) >= as_large * largest; });
}

}  // namespace

Modes vibration_modes(const Scene& scene, std::size_t body, int count) {
  const System system(at_rest_alone(scene, body));
  const Pencil pencil(system);
  if (pencil.size() == 0) return {{}, Eigen::MatrixXd(pencil.free.size(), 0)};  // all nodes are pinned
  const Eigen::Index wanted = std::min<Eigen::Index>(count, pencil.size());
  const bool dense = pencil.size() <= few || 4 * wanted > pencil.size();
  const Pairs pairs = dense ? dense_pairs(pencil, wanted) : sparse_pairs(system, pencil, wanted);
  Modes modes;
  // What is round-off beside the fastest mode is a rigid motion.
  const double fastest = pencil.K.diagonal().maxCoeff() / pencil.M.diagonal().minCoeff();
  modes.omega = (pairs.values.array() > 1e-14 * fastest).select(pairs.values.cwiseMax(0.0).cwiseSqrt(), 0.0);
  modes.shape = Eigen::MatrixXd::Zero(pencil.free.size(), pairs.vectors.cols());
  for (Eigen::Index i = 0, row = 0; i < pencil.free.size(); ++i)
    if (pencil.free[i] != 0) modes.shape.row(i) = pairs.vectors.row(row++);
  for (auto psi : modes.shape.colwise())
    if (leading(psi) < 0) psi = -psi;
  return modes;
}

double fastest_frequency(const Scene& scene, std::size_t body) {
  const System system(at_rest_alone(scene, body));
  const Pencil pencil(system);
  if (pencil.size() == 0) return 0;
  if (pencil.size() <= few) return std::sqrt(dense_pairs(pencil, pencil.size()).values.maxCoeff());
  Product stiffness(pencil.K);
  Spectra::SparseCholesky<double> mass(pencil.M);
  Spectra::SymGEigsSolver<Product, Spectra::SparseCholesky<double>, Spectra::GEigsMode::Cholesky> solver(stiffness,
                                                                                                         mass, 1, 60);
  solver.init();
  solver.compute(Spectra::SortRule::LargestAlge, 1000, 1e-12);
  return std::sqrt(solver.eigenvalues()[0]);
}

bool starts_in_a_mode(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const Body& body) { return body.start.shape == "mode"; });
}

Scene with_modes_started(Scene scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    Body& body = scene.bodies[b];
    if (body.start.shape != "mode") continue;
    const Modes modes = vibration_modes(scene, b, body.start.mode);
    if (modes.omega.size() < body.start.mode)
      throw InputError("body." + std::to_string(b) + ".start.mode",
                       "the body has " + std::to_string(modes.omega.size()) + " vibration modes");
    const auto psi = modes.shape.col(body.start.mode - 1).reshaped(scene.dimension, body.mesh.node_count());
    const double amplitude = body.start.amount.value_or(find_start_shape("mode")->amount);
    const double scale = amplitude / psi.colwise().norm().maxCoeff();
    body.start.nodes.assign(static_cast<std::size_t>(body.mesh.node_count()), Vec3::Zero());
    for (int i = 0; i < body.mesh.node_count(); ++i) {
      Vec3& x = body.start.nodes[static_cast<std::size_t>(i)];
      x.head(body.mesh.dimension()) = body.mesh.X.col(i);
      x.head(scene.dimension) += scale * psi.col(i);
    }
  }
  return scene;
}

}  // namespace sim
