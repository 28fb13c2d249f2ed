// The first six vibration frequencies of the cantilever: eigenvalues of the program's own K and M at rest.
#include <Eigen/SparseCore>
#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/MatOp/SymShiftInvert.h>
#include <Spectra/SymGEigsShiftSolver.h>

#include "sim/solve/tangent_operator.h"
#include "tests/sim/stepping.h"

namespace sim {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

// The free rows and columns of a block matrix.
Sparse free_part(const BlockMatrix& A, const Eigen::VectorXd& free) {
  const int D = A.D();
  std::vector<int> number(free.size(), -1);
  int count = 0;
  for (Eigen::Index i = 0; i < free.size(); ++i)
    if (free[i] != 0) number[i] = count++;
  std::vector<Eigen::Triplet<double>> entries;
  const BlockPattern& pattern = A.pattern();
  for (int i = 0; i < pattern.rows(); ++i)
    for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
      for (int r = 0; r < D; ++r)
        for (int c = 0; c < D; ++c) {
          const int row = number[i * D + r], column = number[pattern.column[k] * D + c];
          if (row >= 0 && column >= 0) entries.emplace_back(row, column, A.block(k)[r * D + c]);
        }
  Sparse B(count, count);
  B.setFromTriplets(entries.begin(), entries.end());
  return B;
}

Eigen::VectorXd frequencies(const Scene& scene, int count) {
  System system(scene);
  const System::Parts& parts = system.parts();
  TangentOperator tangent(parts, 1);
  parts.pins.mark(0, tangent.free());
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(parts.dofs());
  Eigen::VectorXd f(parts.dofs());
  tangent.linearise({parts.X, still, 0, 0}, 0, Definiteness::none, f);
  BlockMatrix K(*parts.pattern, parts.D), M(*parts.pattern, parts.D);
  tangent.assemble(K);
  for (const Mass& mass : parts.masses) mass.add_matrix(1, M);
  const Sparse K_free = free_part(K, tangent.free()), M_free = free_part(M, tangent.free());
  using Shift = Spectra::SymShiftInvert<double, Eigen::Sparse, Eigen::Sparse>;
  using Product = Spectra::SparseSymMatProd<double>;
  Shift shift(K_free, M_free);
  Product product(M_free);
  Spectra::SymGEigsShiftSolver<Shift, Product, Spectra::GEigsMode::ShiftInvert> solver(shift, product, count, 4 * count, 0.0);
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
  scene.bodies[0].mesh = generate_box({4, 1, 1}, {10, 3, 3}, {1.6, 1, 1}, ElementKind::tet10);
  scene.bodies[0].mass = "consistent";
  const Eigen::VectorXd found = frequencies(scene, 6);
  ASSERT_EQ(found.size(), 6);
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(found[k] / reference[k], 1, 0.005) << "frequency " << k + 1;
}

// The same file, row tet 16 x 4 x 4 of linear tets: digit by digit, lumped and consistent.
TEST(Frequencies, OfLinearTetsAreThoseOfTheReferenceCodesOnTheSameMesh) {
  const double consistent[] = {0.3348371, 0.3572045, 1.3226229}, lumped[] = {0.3341549, 0.3560238, 1.2462506};
  Scene scene = test::beam("tet4", 4, 1e6, 0.3);
  for (const char* mass : {"consistent", "lumped"}) {
    scene.bodies[0].mass = mass;
    const Eigen::VectorXd found = frequencies(scene, 3);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(found[k] / (std::string(mass) == "lumped" ? lumped : consistent)[k], 1, 0.01) << mass << " " << k;
  }
}

}  // namespace
}  // namespace sim
