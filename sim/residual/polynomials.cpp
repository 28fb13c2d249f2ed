#include "sim/residual/basis.h"
#include "sim/residual/legendre.h"

namespace sim::residual {

// (P_{i+1} - P_{i-1})' = (2i + 1) P_i in t, and dt/dx = 2, so u_i' = P_i(t) and u_i'' = 2 P_i'(t): the matrix of -u''
// is diagonal, 1/(2i + 1).
void sample_polynomials(Real x, std::span<Sample> all) {
  const Real t = 2 * x - 1;
  Legendre P = next(Legendre{}, 0, t);  // P_1
  for (std::size_t k = 0; k < all.size(); ++k) {
    const int i = static_cast<int>(k) + 1;
    const Legendre after = next(P, i, t);
    all[k] = {(after.value - P.before) / (2 * (2 * i + 1)), P.value, 2 * P.slope};
    P = after;
  }
}

// With t = 2x - 1 the recurrence of P holds for the coefficients of powers of x as well. A polynomial that is zero at
// both ends is p = (1 - x) sum b_i x^i: b_i = p_i + b_{i-1}, as p_i = b_i - b_{i-1}.
Vector to_monomials(const Vector& c) {
  const Eigen::Index n = c.size(), size = n + 2;
  const auto times_t = [&](const Vector& p) {
    Vector product = -p;
    product.tail(size - 1) += 2 * p.head(size - 1);
    return product;
  };
  Vector before = Vector::Unit(size, 0), P = times_t(before), sum = Vector::Zero(size);
  for (Eigen::Index i = 1; i <= n; ++i) {
    const Vector after = (Real(2 * i + 1) * times_t(P) - Real(i) * before) / Real(i + 1);
    sum += c[i - 1] * (after - before) / Real(2 * (2 * i + 1));
    before = P;
    P = after;
  }
  Vector b(n);
  Real last = sum[0];
  for (Eigen::Index i = 1; i <= n; ++i) b[i - 1] = last += sum[i];
  return b;
}

}  // namespace sim::residual
