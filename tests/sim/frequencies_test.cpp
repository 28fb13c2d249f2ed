// The first six vibration frequencies of the cantilever: eigenvalues of the program's own K and M at rest.
#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/MatOp/SymShiftInvert.h>
#include <Spectra/SymGEigsShiftSolver.h>

#include "sim/build/parts.h"
#include "sim/mesh/refine.h"
#include "sim/solve/tangent_operator.h"
#include "tests/sim/sparse.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

Eigen::VectorXd frequencies(const Scene& scene, int count) {
  System system(scene);
  const Model& parts = parts_of(system).model;
  TangentOperator tangent(parts, 1);
  parts.pins.mark(0, tangent.free());
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(parts.dofs());
  Eigen::VectorXd f(parts.dofs());
  tangent.linearise({parts.X, still, 0, 0}, 0, Definiteness::none, f);
  BlockMatrix K(*parts.pattern, parts.D), M(*parts.pattern, parts.D);
  tangent.assemble(K);
  for (const Mass& mass : parts.masses) mass.add_matrix(1, M);
  const test::Sparse K_free = test::free_part(K, tangent.free()), M_free = test::free_part(M, tangent.free());
  using Shift = Spectra::SymShiftInvert<double, Eigen::Sparse, Eigen::Sparse>;
  using Product = Spectra::SparseSymMatProd<double>;
  Shift shift(K_free, M_free);
  Product product(M_free);
  Spectra::SymGEigsShiftSolver<Shift, Product, Spectra::GEigsMode::ShiftInvert> solver(shift, product, count, 4 * count,
                                                                                       0.0);
  solver.init();
  solver.compute(Spectra::SortRule::LargestMagn);
  Eigen::VectorXd omega2 = solver.eigenvalues();
  std::sort(omega2.begin(), omega2.end());
  return omega2.cwiseSqrt() / (2 * 3.14159265358979323846);
}

// tests/data/reference/beam3d_frequencies_nu0.3.csv, finest rows; 1e-4.
TEST(Frequencies, OfTheCantileverWithinHalfAPerCent) {
  const double reference[] = {0.30792, 0.30792, 1.13023, 1.55922, 1.55922, 1.98902};
  Scene scene = test::beam("tet10", 2, 1e6, 0.3);
  scene.bodies[0].mesh = generate_box({4, 1, 1}, {12, 4, 4}, {1.6, 1, 1}, ElementKind::tet10);
  scene.bodies[0].mass = MassMatrix::consistent;
  const Eigen::VectorXd found = frequencies(scene, 6);
  ASSERT_EQ(found.size(), 6);
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(found[k] / reference[k], 1, 0.005) << "frequency " << k + 1;
}

// Ritz: with consistent mass every frequency is an upper bound, and refining brings it down.
TEST(Frequencies, AreUpperBoundsThatRefiningLowers) {
  const double reference[] = {0.30792, 0.30792, 1.13023, 1.55922, 1.55922, 1.98902};
  Scene scene = test::beam("tet4", 2, 1e6, 0.3);
  scene.bodies[0].mass = MassMatrix::consistent;
  const Eigen::VectorXd coarse = frequencies(scene, 6);
  scene.bodies[0].mesh = refine(scene.bodies[0].mesh);
  const Eigen::VectorXd fine = frequencies(scene, 6);
  for (int k = 0; k < 6; ++k) {
    EXPECT_LT(fine[k], coarse[k]);
    EXPECT_GT(fine[k], reference[k] * (1 - 1e-4));
  }
  EXPECT_GT(coarse[0], 1.05 * reference[0]) << "linear tets this coarse are too stiff";
}

}  // namespace
}  // namespace sim
